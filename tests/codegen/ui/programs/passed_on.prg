3.1
of the crate that invokes it
REL_PTP F6 0 0 20
END
