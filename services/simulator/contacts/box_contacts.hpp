#pragma once

namespace markservo::simulator {

// MuJoCo 2.2.2 now and then reports a contact between two boxes that lies outside both, with a depth of decimetres
// (seen with a book that stands turned on the shelf), and the solver throws the book away. This puts a check behind
// MuJoCo's own box-box collision: contacts outside either box are dropped. Process-wide; repeated calls change nothing.
void drop_impossible_box_contacts();

}  // namespace markservo::simulator
