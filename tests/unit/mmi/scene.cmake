markservo_test(mmi_scene_test
  SOURCES
    arm_points_test.cpp floor_view_test.cpp hello_json_test.cpp message_slots_test.cpp places_test.cpp
    pose_history_test.cpp reason_words_test.cpp scene_json_test.cpp scene_messages_test.cpp state_changes_test.cpp
    state_changes_bounds_test.cpp
  LINK mmi_scene all_types bus)
