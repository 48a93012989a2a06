"""What the rest uses and has no physics: checks, files, pictures, progress, work on many processes."""
