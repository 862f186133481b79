package org.maestro.rats.protocol;

/** The outcome of a call. */
public enum Outcome {
  SUCCEEDED,
  FAILED,
  TIMED_OUT,
  CANCELED,
  REJECTED
}
