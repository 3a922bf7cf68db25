#pragma once

/// Prints how many bytes a saved body takes, and how long saving, restoring and hashing a world of 1000 take.
void measureSnapshots();
