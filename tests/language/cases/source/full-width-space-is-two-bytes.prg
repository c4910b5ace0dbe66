3.1
full width space is two bytes
MESSAGE a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　b
MESSAGE a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　a　bc
END
