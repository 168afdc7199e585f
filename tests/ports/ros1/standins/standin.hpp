// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What makes a structure with kType, kSum and all() a message of ROS 1.
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#define TERN_ROS1_STANDIN(Message)                                      \
  namespace ros::message_traits {                                       \
  template <>                                                           \
  struct IsMessage<Message> : TrueType {};                              \
  template <>                                                           \
  struct HasHeader<Message> : TrueType {};                              \
  template <>                                                           \
  struct MD5Sum<Message> {                                              \
    static const char* value() { return Message::kSum; }                \
    static const char* value(const Message&) { return Message::kSum; }  \
  };                                                                    \
  template <>                                                           \
  struct DataType<Message> {                                            \
    static const char* value() { return Message::kType; }               \
    static const char* value(const Message&) { return Message::kType; } \
  };                                                                    \
  template <>                                                           \
  struct Definition<Message> {                                          \
    static const char* value() { return Message::kType; }               \
    static const char* value(const Message&) { return Message::kType; } \
  };                                                                    \
  }                                                                     \
  namespace ros::serialization {                                        \
  template <>                                                           \
  struct Serializer<Message> {                                          \
    template <typename Stream, typename Self>                           \
    inline static void allInOne(Stream& stream, Self m) {               \
      Message::all(stream, m);                                          \
    }                                                                   \
    ROS_DECLARE_ALLINONE_SERIALIZER                                     \
  };                                                                    \
  }
