# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""The flight node with a RealSense camera, and PX4's bridge or MAVROS.

  ros2 launch tern_ros flight.launch.py output:=px4

Where the camera sits on the body: mounting:="x y z yaw pitch roll". For a lifecycle manager of yours, set
autostart:=false."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import LifecycleNode, Node

ARGUMENTS = {"output": "px4", "autostart": "true", "image": "/camera/depth/image_rect_raw",
             "camera_info": "/camera/depth/camera_info", "odometry": "/mavros/local_position/odom",
             "mounting": "0.1 0 0 0 0 0"}


def nodes(context):
    value = {name: LaunchConfiguration(name).perform(context) for name in [*ARGUMENTS, "config"]}
    x, y, z, yaw, pitch, roll = value["mounting"].split()
    return [
        Node(package="tf2_ros", executable="static_transform_publisher", name="tern_camera",
             arguments=["--x", x, "--y", y, "--z", z, "--yaw", yaw, "--pitch", pitch, "--roll", roll,
                        "--frame-id", "base_link", "--child-frame-id", "camera_link"]),
        LifecycleNode(package="tern_ros", executable="tern_flight_node", name="tern", namespace="", output="screen",
                      parameters=[value["config"], {"output": value["output"],
                                                    "autostart": value["autostart"] == "true"}],
                      remappings=[("camera/image", value["image"]), ("camera/camera_info", value["camera_info"]),
                                  ("odometry", value["odometry"])])]


def generate_launch_description():
    config = os.path.join(get_package_share_directory("tern_ros"), "config", "flight.yaml")
    return LaunchDescription([*(DeclareLaunchArgument(name, default_value=value) for name, value in ARGUMENTS.items()),
                              DeclareLaunchArgument("config", default_value=config), OpaqueFunction(function=nodes)])
