markservo_test(mmi_troubles_test
  SOURCES
    activity_test.cpp every_trouble_test.cpp good_run_test.cpp sight_troubles_test.cpp state_json_test.cpp
    trouble_memory_test.cpp trouble_messages_test.cpp trouble_rules_test.cpp
  LINK mmi_troubles bus lcmtypes logs GTest::gmock)
markservo_test(mmi_stop_test SOURCES stop_requester_test.cpp LINK mmi_stop GTest::gmock)
markservo_test(mmi_control_test SOURCES desk_test.cpp LINK mmi_control GTest::gmock nlohmann_json::nlohmann_json)
