/** The fields of all message types, in their order; ../lcm_types.mjs makes it of lcmtypes/*.lcm. */
declare module 'lcmtypes' {
  export interface MessageField {
    name: string;
    /** As written: double, int8_t, or another type's name. Arrays have their elements'. */
    kind: string;
    /** The constants that name its values, by their numbers. */
    names?: string[];
  }
  export const kMessageTypes: Record<string, MessageField[]>;
}
