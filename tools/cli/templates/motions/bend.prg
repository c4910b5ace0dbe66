3.1
One leg or finger after the other bends its joints, and goes back

