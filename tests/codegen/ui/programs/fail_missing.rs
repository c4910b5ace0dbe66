tip_macros::include_tip!("/no/such/folder/gone.prg");

fn main() {
    let _ = Gone::new();
}
