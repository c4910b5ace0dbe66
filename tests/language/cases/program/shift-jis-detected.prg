3.1
Ž©“®”»•Ê
MESSAGE@‹r‚ðã‚°‚é
END
