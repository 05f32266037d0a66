"""Robot files as sheets of limbs and joints, changed row by row and written back."""
