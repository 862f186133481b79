package org.maestro.rats.protocol;

/** How a call ended. */
public enum Outcome {
  SUCCEEDED,
  FAILED,
  TIMED_OUT,
  CANCELED,
  REJECTED
}
