#pragma once
// The services and the action of `slackwater live`, as its clients call them.
#include "action_msgsPubSubTypes.h"
#include "slackwater_msgsPubSubTypes.h"
#include "std_srvsPubSubTypes.h"
#include "tests/strangers/live/service_client.h"

namespace peer {

using Trigger = ServiceClient<std_srvs::srv::Trigger_RequestPubSubType,
                              std_srvs::srv::Trigger_ResponsePubSubType>;
using SetBool = ServiceClient<std_srvs::srv::SetBool_RequestPubSubType,
                              std_srvs::srv::SetBool_ResponsePubSubType>;
using SetWaypoints = ServiceClient<slackwater_msgs::srv::SetWaypoints_RequestPubSubType,
                                   slackwater_msgs::srv::SetWaypoints_ResponsePubSubType>;
using Step = ServiceClient<slackwater_msgs::srv::Step_RequestPubSubType,
                           slackwater_msgs::srv::Step_ResponsePubSubType>;
using QueryProfile = ServiceClient<slackwater_msgs::srv::QueryProfile_RequestPubSubType,
                                   slackwater_msgs::srv::QueryProfile_ResponsePubSubType>;
using Spawn = ServiceClient<slackwater_msgs::srv::Spawn_RequestPubSubType,
                            slackwater_msgs::srv::Spawn_ResponsePubSubType>;
using SendGoal = ServiceClient<slackwater_msgs::action::Navigate_SendGoal_RequestPubSubType,
                               slackwater_msgs::action::Navigate_SendGoal_ResponsePubSubType>;
using CancelGoal = ServiceClient<action_msgs::srv::CancelGoal_RequestPubSubType,
                                 action_msgs::srv::CancelGoal_ResponsePubSubType>;
using GetResult = ServiceClient<slackwater_msgs::action::Navigate_GetResult_RequestPubSubType,
                                slackwater_msgs::action::Navigate_GetResult_ResponsePubSubType>;

}  // namespace peer
