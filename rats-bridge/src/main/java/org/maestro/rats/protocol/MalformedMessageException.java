package org.maestro.rats.protocol;

/** A payload is no valid message; names the field and the rule that it breaks. */
public final class MalformedMessageException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final ErrorCode code;
  private final String field;

  MalformedMessageException(ErrorCode code, String field, String rule, String found) {
    super("The message's " + field + " must be " + rule + ", but is " + found);
    this.code = code;
    this.field = field;
  }

  MalformedMessageException(String field, String rule, String found) {
    this(ErrorCode.MALFORMED, field, rule, found);
  }

  /** MALFORMED, or UNSUPPORTED_VERSION. */
  public ErrorCode code() {
    return code;
  }

  /** Such as {@code p} or {@code error.refs[0].fact}; {@code payload} for the whole. */
  public String field() {
    return field;
  }
}
