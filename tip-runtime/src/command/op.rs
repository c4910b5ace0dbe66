//! The commands of the robot (T.I.P. 3.1 §7, and §1-2 for those of edition 3.2).

use super::UnknownWord;
use core::fmt;
use core::str::FromStr;

macro_rules! ops {
    ($( $variant:ident $name:literal $traced:literal, )*) => {
        /// The commands that a robot carries out.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Op {
            $( #[doc = concat!("`", $name, "`")] $variant, )*
        }

        impl Op {
            /// Every command, in the order of the language's reference.
            pub const ALL: &'static [Op] = &[$( Op::$variant, )*];

            /// Returns the command's name in the language.
            pub const fn name(self) -> &'static str {
                match self { $( Op::$variant => $name, )* }
            }

            /// Returns true if a trace shows the command under `cmd`.
            pub const fn is_traced(self) -> bool {
                match self { $( Op::$variant => $traced, )* }
            }
        }
    };
}

ops! {
    Ptp "PTP" true,
    RelPtp "REL_PTP" true,
    PtpAngle "PTP_ANGLE" true,
    RelPtpAngle "REL_PTP_ANGLE" true,
    AllStop "ALL_STOP" true,
    AllStopRelease "ALL_STOP_RELEASE" true,
    InitialPosture "INITIAL_POSTURE" true,
    VelControl "VEL_CONTROL" true,
    OmegaControl "OMEGA_CONTROL" true,
    Torque "TORQUE" true,
    Force "FORCE" true,
    ComplianceAngle "COMPLIANCE_ANGLE" true,
    RelComplianceAngle "REL_COMPLIANCE_ANGLE" true,
    CompliancePosition "COMPLIANCE_POSITION" true,
    RelCompliancePosition "REL_COMPLIANCE_POSITION" true,
    NoCompliance "NO_COMPLIANCE" true,
    Sleep "SLEEP" false,
    WaitInpos "WAIT_INPOS" false,
    WaitNear "WAIT_NEAR" false,
    SetAMax "SET_A_MAX" true,
    SetVMax "SET_V_MAX" true,
    SetAMaxRate "SET_A_MAX_RATE" true,
    SetVMaxRate "SET_V_MAX_RATE" true,
    SetAMaxSlow "SET_A_MAX_SLOW" true,
    SetAMaxFast "SET_A_MAX_FAST" true,
    SetAMaxNormal "SET_A_MAX_NORMAL" true,
    SetVMaxSlow "SET_V_MAX_SLOW" true,
    SetVMaxFast "SET_V_MAX_FAST" true,
    SetVMaxNormal "SET_V_MAX_NORMAL" true,
    SetJustPosition "SET_JUST_POSITION" true,
    SetNearPosition "SET_NEAR_POSITION" true,
    SetOmegaMax "SET_OMEGA_MAX" true,
    SetOmegaDotMax "SET_OMEGA_DOT_MAX" true,
    SetOmegaMaxRate "SET_OMEGA_MAX_RATE" true,
    SetOmegaDotMaxRate "SET_OMEGA_DOT_MAX_RATE" true,
    SetOmegaMaxSlow "SET_OMEGA_MAX_SLOW" true,
    SetOmegaMaxFast "SET_OMEGA_MAX_FAST" true,
    SetOmegaMaxNormal "SET_OMEGA_MAX_NORMAL" true,
    SetOmegaDotMaxSlow "SET_OMEGA_DOT_MAX_SLOW" true,
    SetOmegaDotMaxFast "SET_OMEGA_DOT_MAX_FAST" true,
    SetOmegaDotMaxNormal "SET_OMEGA_DOT_MAX_NORMAL" true,
    SetJustAngle "SET_JUST_ANGLE" true,
    SetNearAngle "SET_NEAR_ANGLE" true,
    SetTorqueMax "SET_TORQUE_MAX" true,
    SetTorqueMaxRate "SET_TORQUE_MAX_RATE" true,
    SetTorqueMaxSoft "SET_TORQUE_MAX_SOFT" true,
    SetTorqueMaxFirmly "SET_TORQUE_MAX_FIRMLY" true,
    SetTorqueMaxNormal "SET_TORQUE_MAX_NORMAL" true,
    SetAngleStiffness "SET_ANGLE_STIFFNESS" true,
    SetPositionStiffness "SET_POSITION_STIFFNESS" true,
    SetComplianceTorqueLimit "SET_COMPLIANCE_TORQUE_LIMIT" true,
    ResetComplianceTorqueLimit "RESET_COMPLIANCE_TORQUE_LIMIT" true,
    SetComplianceForceLimit "SET_COMPLIANCE_FORCE_LIMIT" true,
    ResetComplianceForceLimit "RESET_COMPLIANCE_FORCE_LIMIT" true,
    SetSamplingTime "SET_SAMPLING_TIME" true,
    SetSamplingFreq "SET_SAMPLING_FREQ" true,
    FlushBuf "FLUSH_BUF" false,
    LampOn "LAMP_ON" false,
    LampOff "LAMP_OFF" false,
    SilentOn "SILENT_ON" false,
    SilentOff "SILENT_OFF" false,
    LogStart "LOG_START" false,
    LogStop "LOG_STOP" false,
    LogOneShot "LOG_ONE_SHOT" false,
    OutputVariables "OUTPUT_VARIABLES" false,
    EmgOff "EMG_OFF" true,
    EmgOn "EMG_ON" true,
    Special "SPECIAL" true,
    StandUp "STAND_UP" true,
    SitDown "SIT_DOWN" true,
    DetectFloor "DETECT_FLOOR" true,
    DetectObject "DETECT_OBJECT" true,
    StartTimer "START_TIMER" false,
    StopTimer "STOP_TIMER" false,
    RestartTimer "RESTART_TIMER" false,
    ResetTimer "RESET_TIMER" false,
    SpeedUp "TIP_SPEED_UP" true,
    Direct "DIRECT" true,
    Trajectory "TRAJECTORY" true,
    Lock "LOCK" true,
    Unlock "UNLOCK" true,
    SetLimit "SET_LIMIT" true,
    ResetLimit "RESET_LIMIT" true,
}

impl Op {
    /// Returns true if the turn of a program that runs several steps in a cycle ends with the command: it waits, or its
    /// effect shows outside of the robot.
    pub const fn ends_turn(self) -> bool {
        matches!(
            self,
            Op::Sleep
                | Op::WaitInpos
                | Op::WaitNear
                | Op::InitialPosture
                | Op::StandUp
                | Op::SitDown
                | Op::DetectFloor
                | Op::DetectObject
                | Op::Special
                | Op::OutputVariables
                | Op::LogStart
                | Op::LogStop
                | Op::LogOneShot
        )
    }
}

impl fmt::Display for Op {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Op {
    type Err = UnknownWord;

    /// Parses a name in capital letters.
    fn from_str(word: &str) -> Result<Self, UnknownWord> {
        let named = Op::ALL.iter().find(|op| op.name() == word);
        named.copied().ok_or(UnknownWord)
    }
}
