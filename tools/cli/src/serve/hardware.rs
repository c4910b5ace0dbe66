//! `tip serve --hardware`: the live page of a robot on servos. The control cycle has a thread of its own (`control`). What must not
//! wait for the hub, the driver's signs of life and the emergency stop, goes from the threads of connections to `controls`, which
//! that thread looks at in each cycle.

mod control;

use super::controls::Controls;
use super::hub::{LiveSession, Outbox};
use super::{Serve, ServedFile};
use crate::drives::robot::{Connection, Setup, report_stiff};
use crate::error::Error;
use crate::message::{Driving, Using};
use crate::setup::ChosenRobot;
use crate::{Status, input, interrupt, output, report, sticks};
use control::{Control, Report};
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;
use tip_sim::Robot;
use tip_view::live::{
    CheckedText, ClientRequest, DrivenSession, Host, Order, Rules, UncheckedText, Viewer,
};

/// The session of a robot on servos: it follows the control cycle.
pub(super) struct Follower {
    session: DrivenSession,
    file: ServedFile,
    controls: Arc<Controls>,
    orders: Sender<Order>,
    reports: Receiver<Report>,
}

impl LiveSession for Follower {
    fn advance(&mut self, _: Duration, goes_on: &dyn Fn() -> bool) {
        while goes_on() {
            match self.reports.try_recv() {
                Ok(report) => report.tell(&mut self.session),
                Err(TryRecvError::Empty) => break,
                // The control cycle has ended; so does the command.
                Err(TryRecvError::Disconnected) => {
                    interrupt::request();
                    break;
                }
            }
        }
        for order in self.session.take_orders() {
            // A control cycle that has ended obeys no order.
            let _ = self.orders.send(order);
        }
    }

    fn ask(&mut self, viewer: &Outbox, asked: &ClientRequest) -> Option<String> {
        let is_holder = self.controls.driver().holder() == Some(viewer.number);
        self.session.ask(asked, is_holder, &mut self.file)
    }

    fn update(&self, outbox: &Outbox, viewer: &mut Viewer) -> Option<String> {
        let driver = self.controls.driver().clone();
        self.session.update(viewer, outbox.number, &driver)
    }

    fn unchecked(&mut self) -> Option<UncheckedText> {
        self.session.unchecked()
    }

    fn checked(&mut self, reading: CheckedText) {
        self.session.checked(reading);
    }

    fn file_changed(&mut self) {
        if let Ok(bytes) = self.file.read() {
            self.session.file_changed(&bytes);
        }
    }
}

/// The control cycle before it starts.
pub(super) struct Prepared {
    control: Control,
    pub(super) controls: Arc<Controls>,
    has_priority: bool,
}

impl Prepared {
    /// Starts the thread of the control cycle.
    pub(super) fn start(self) -> RunningControl {
        let has_priority = self.has_priority;
        let thread = thread::spawn(move || self.control.work(has_priority));
        RunningControl(Some(thread))
    }
}

/// The thread of the control cycle. Whatever ends the one that dropped it, a panic included, the robot is left first.
pub(super) struct RunningControl(Option<JoinHandle<Status>>);

impl RunningControl {
    /// Waits until the robot is left, and returns the status of the command.
    pub(super) fn end(mut self) -> Status {
        self.join()
    }

    fn join(&mut self) -> Status {
        let ended = self.0.take().map(JoinHandle::join);
        // A control cycle that panicked has left the robot as in an emergency.
        ended.and_then(Result::ok).unwrap_or(Status::Emergency)
    }
}

impl Drop for RunningControl {
    fn drop(&mut self) {
        interrupt::request();
        self.join();
    }
}

/// Finds the servos of a robot; returns the session, and the control cycle that it follows.
pub(super) fn prepare(
    arguments: &Serve,
    file: &Path,
) -> Result<(Follower, Prepared, Robot), Error> {
    interrupt::catch();
    let lang = arguments.run.source.output_options.lang();
    let path = arguments.run.file.as_path();
    let (mut subject, setup, served) = arguments.subject(path)?;
    let ChosenRobot::Described(description) = &subject.chosen else {
        let file = file.display().to_string().into();
        return Err(Error::failed(Driving::NoBus { file }, lang));
    };
    let events = match &subject.loaded.program {
        Some(program) => sticks::let_rest(program, setup.events.clone()),
        None => setup.events.clone(),
    };
    let unconnected = subject.robot.unconnected(&subject.loaded, &events);
    if !unconnected.is_empty() {
        subject.loaded.program = None;
        subject.loaded.report(unconnected.into());
    }
    let output_options = arguments.run.source.output_options;
    if let Some(trace) = &arguments.trace {
        if input::is_stream(trace) {
            return Err(Error::usage(Using::ServeTrace, lang));
        }
        output::refuse_inputs(trace, &arguments.run.files())?;
        // Each run begins it anew; here it is only tried.
        output::begin(trace).map_err(|error| Error::cannot_write(trace, error))?;
    }
    if subject.loaded.program.is_none() {
        return Err(Error::Refused(Box::new(subject.loaded), output_options));
    }
    let robot_setup = Setup::new(file, description, lang)?;
    let rules = Rules::of(&robot_setup.bus);
    let connection = robot_setup.open(file, arguments.port.as_deref(), lang)?;
    if let Err(error) = connect(&connection, arguments) {
        report_stiff(&connection, lang);
        return Err(error);
    }
    let refused = |loaded| Error::Refused(loaded, output_options);
    let session = DrivenSession::new(setup, sticks::let_rest).map_err(refused)?;
    let stop = Arc::clone(&connection.robot().host_mut().stop);
    let controls = Arc::new(Controls::new(rules, stop));
    let (orders, ordered) = channel();
    let (reports, reported) = channel();
    let robot = subject.robot;
    let control = Control::new(
        connection,
        robot.clone(),
        Arc::clone(&controls),
        (ordered, reports),
        arguments.trace.clone(),
        lang,
    );
    let follower = Follower {
        session,
        file: served,
        controls: Arc::clone(&controls),
        orders,
        reports: reported,
    };
    let prepared = Prepared {
        control,
        controls,
        has_priority: arguments.fifo,
    };
    Ok((follower, prepared, robot))
}

/// Finds the servos, and says where they will go.
fn connect(connection: &Connection, arguments: &Serve) -> Result<(), Error> {
    let lang = arguments.run.source.output_options.lang();
    connection.connect(arguments.quiet)?;
    if !arguments.quiet {
        connection.announce();
        report::say(Driving::ServeStarts, lang);
    }
    Ok(())
}
