//! What a step can ask of a robot: commands, targets, values, inputs and event flags.

use core::fmt;

/// The most legs, and the most joints on a leg, that the language can name (`F1…F9`, `J11…J99`).
pub const MAX: usize = 9;

/// What a command acts on. Legs and joints count from 1, as in the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// The command has no target.
    None,
    /// `ALL`.
    All,
    /// `FLOOR`: the slider of the Hiroshima Hand.
    Floor,
    /// `Fn`: a foot or finger.
    Foot(u8),
    /// `Jnm`: joint m of leg n.
    Joint(u8, u8),
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Target::None => Ok(()),
            Target::All => f.write_str("ALL"),
            Target::Floor => f.write_str("FLOOR"),
            Target::Foot(leg) => write!(f, "F{leg}"),
            Target::Joint(leg, joint) => write!(f, "J{leg}{joint}"),
        }
    }
}

/// One evaluated operand of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number as it stands.
    Absolute(f64),
    /// A number behind `R`.
    Relative(f64),
}

impl Value {
    /// The number as the operand gave it.
    pub const fn number(self) -> f64 {
        match self {
            Value::Absolute(number) | Value::Relative(number) => number,
        }
    }
}

/// A command with its operands evaluated. A struct operand stands as its members.
#[derive(Clone, Copy, Debug)]
pub struct Command<'a> {
    /// Which command.
    pub op: Op,
    /// `HS`: without acceleration limit.
    pub hs: bool,
    /// What it acts on.
    pub target: Target,
    /// Its operands in order; omitted ones are absent.
    pub values: &'a [Value],
}

/// Whether a command is done; a pending one is asked again in the next cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Poll {
    /// The program goes on to the next step.
    Done,
    /// The program stays on this step.
    Pending,
}

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

            /// The command's name in the language.
            pub const fn name(self) -> &'static str {
                match self { $( Op::$variant => $name, )* }
            }

            /// Whether a trace shows the command under `cmd`.
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
}

/// What a teaching command measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Teach {
    /// Position of a foot or joint: X, Y, Z in mm.
    Position,
    /// Joint angles in degrees.
    Angle,
    /// Joint torques in the robot's torque unit.
    Torque,
    /// Contact force at a fingertip or second joint: X, Y, Z in N.
    Force,
}

/// An analogue input, read in volts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Port {
    /// A channel of the A/D board, 0…15.
    Channel(u8),
    /// `VR1…VR3`: the potentiometers of the control box.
    Knob(u8),
    /// `Jnm`: a joint's potentiometer.
    Joint(u8, u8),
    /// `PAW1…PAW4`: the pressure sensor of a sole.
    Paw(u8),
    /// `ANTENNA`: the feeler (TITAN VIII) or palm touch (Hiroshima Hand).
    Antenna,
}

/// An event flag of a condition (T.I.P. 3.1 §6-2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Flag {
    /// Somebody asked the program to stop at the next good moment.
    HaltRequest,
    /// The keyboard buffer is not empty.
    KbHit,
    /// The target has arrived within the JUST tolerance.
    Inpos(Target),
    /// The target has arrived within the NEAR tolerance.
    Near(Target),
    /// `SPECIAL_FLAG0…9`, set by native code.
    Special(u8),
    /// The palm touches (Hiroshima Hand).
    Antenna,
}
