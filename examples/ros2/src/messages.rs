//! The ROS messages of the node, as CDR has them, with their DDS names.

use serde::{Deserialize, Serialize};

/// `builtin_interfaces/msg/Time`
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Time {
    /// s
    pub sec: i32,
    /// ns
    pub nanosec: u32,
}

/// `std_msgs/msg/Header`
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Header {
    /// Time of the data.
    pub stamp: Time,
    /// Empty here.
    pub frame_id: String,
}

/// `sensor_msgs/msg/JointState`: rad, rad/s.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct JointState {
    /// Time of the data.
    pub header: Header,
    /// Names of the joints.
    pub name: Vec<String>,
    /// rad
    pub position: Vec<f64>,
    /// rad/s, or empty.
    pub velocity: Vec<f64>,
    /// Empty here.
    pub effort: Vec<f64>,
}

/// DDS name of [`JointState`].
pub const JOINT_STATE: &str = "sensor_msgs::msg::dds_::JointState_";

/// `std_msgs/msg/String`
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Text {
    /// The text.
    pub data: String,
}

/// DDS name of [`Text`].
pub const TEXT: &str = "std_msgs::msg::dds_::String_";

/// Request of a service: the header of rmw_cyclonedds, and `std_srvs/srv/Trigger`, which has one unused byte.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct TriggerRequest {
    /// The client.
    pub client: u64,
    /// Number of the request.
    pub number: i64,
    /// An empty structure is a byte.
    pub unused: u8,
}

/// DDS name of [`TriggerRequest`].
pub const TRIGGER_REQUEST: &str = "std_srvs::srv::dds_::Trigger_Request_";

/// Reply of a service: the header of its request, and `std_srvs/srv/Trigger`.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct TriggerReply {
    /// The client.
    pub client: u64,
    /// Number of the request.
    pub number: i64,
    /// True if it was done.
    pub success: bool,
    /// The reason if not.
    pub message: String,
}

/// DDS name of [`TriggerReply`].
pub const TRIGGER_REPLY: &str = "std_srvs::srv::dds_::Trigger_Response_";

/// `diagnostic_msgs/msg/KeyValue`
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct KeyValue {
    /// Name of the value.
    pub key: String,
    /// The value.
    pub value: String,
}

/// `diagnostic_msgs/msg/DiagnosticStatus`
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Status {
    /// 0 well, 1 a warning, 2 an error.
    pub level: u8,
    /// Name of the part.
    pub name: String,
    /// Summary.
    pub message: String,
    /// The robot.
    pub hardware_id: String,
    /// Details.
    pub values: Vec<KeyValue>,
}

/// `diagnostic_msgs/msg/DiagnosticArray`
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Diagnostics {
    /// Time of the data.
    pub header: Header,
    /// One for each part.
    pub status: Vec<Status>,
}

/// DDS name of [`Diagnostics`].
pub const DIAGNOSTICS: &str = "diagnostic_msgs::msg::dds_::DiagnosticArray_";
