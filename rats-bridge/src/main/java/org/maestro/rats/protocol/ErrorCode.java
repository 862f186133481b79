package org.maestro.rats.protocol;

/** Every error code of the bus; public API. */
public enum ErrorCode {
  /** The payload is not a valid message of this version. */
  MALFORMED,
  UNSUPPORTED_VERSION,
  UNKNOWN_FEATURE,
  INVALID_PARAMETERS,
  PRECONDITION_NOT_MET,
  /** The member's present state or what runs on it does not allow the feature. */
  DISABLED,
  QUEUE_FULL,
  DUPLICATE_ID,
  RESTARTED,
  EXPIRED,
  TIMEOUT,
  CANCELED,
  NOT_AUTHORISED,
  HARDWARE_FAILURE,
  /** Nobody answered for the member: it is lost, or the bus is. */
  MEMBER_LOST,
  BUS_UNAVAILABLE,
  INTERNAL
}
