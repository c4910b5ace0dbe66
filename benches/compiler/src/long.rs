//! Programs of any length, for the compiler to chew on.

use std::error::Error;

/// A kind of program, and what writes one of a number of lines.
pub(crate) type Kind = (&'static str, fn(usize) -> String);

/// Programs as people write them, and such as have much of one thing.
pub(crate) const KINDS: &[Kind] = &[
    ("mixed", mixed),
    ("motions", |lines| {
        repeated(lines, |_| "PTP F1 -391 R 2 -150".to_owned())
    }),
    ("equations", |lines| {
        repeated(lines, |_| "D = B + 1.5".to_owned())
    }),
    ("variables", |lines| {
        repeated(lines / 3, |n| format!("DEF_VAR V{n}\nV{n} = D\nB = V{n}"))
    }),
    ("jumps", |lines| {
        let last = lines / 2 - 1;
        repeated(lines / 2, move |n| format!("L{n}:\nGOTO L{}:", last - n))
    }),
    ("messages", |lines| {
        repeated(lines, |_| "MESSAGE hello %D%".to_owned())
    }),
    ("blocks", |lines| {
        repeated(lines / 10, |n| {
            format!(
                "IF KB_HIT THEN\nD = {n}\nELSEIF B > {n} THEN\nB += 1\nENDIF\n\
                 WHILE D < 10\nD += 1\nWEND\nFOR C = 1 TO 3\nNEXT"
            )
        })
    }),
    ("comments", |lines| {
        repeated(lines, |n| format!("  // what the foot does after step {n}"))
    }),
];

/// The program of a kind with that many lines.
pub(crate) fn program(kind: &str, lines: usize) -> Result<String, Box<dyn Error>> {
    let names: Vec<&str> = KINDS.iter().map(|(name, _)| *name).collect();
    let known = KINDS.iter().find(|(name, _)| *name == kind);
    let (_, write) = known.ok_or_else(|| format!("the kinds are {}", names.join(", ")))?;
    Ok(write(lines))
}

/// A bit of everything: ten lines, ten steps, again and again.
pub(crate) fn mixed(lines: usize) -> String {
    repeated(lines / 10, |n| {
        format!(
            "PTP F1 -391 201 -150\n\
             WAIT_INPOS ALL\n\
             D = B + 1.5\n\
             IF D > 100 GOTO L{n}:\n\
             SLEEP 100\n\
             L{n}:\n\
             FOR B = 1 TO 10\n  \
               C += 0.5\n  \
               MESSAGE B is %B%\n\
             NEXT"
        )
    })
}

fn repeated(times: usize, piece: impl Fn(usize) -> String) -> String {
    let body: String = (0..times).map(|n| piece(n) + "\n").collect();
    format!("3.1\na long program\nDEF_VAR B C D\nB = 0\nC = 0\nD = 0\n{body}END\n")
}
