package org.maestro.console.questions;

/** A question or an order that was not answered; the message is one sentence for who asked. */
public final class RefusalException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Who can do something about it. */
  public enum Kind {
    /** Who asked: the words are wrong, or speak of what is not there. */
    BAD_INPUT,
    /** Who asked: here is nothing of the kind. */
    NOT_THERE,
    /** Something outside failed, or is not there now; the same may be answered later. */
    OUTSIDE
  }

  private final Kind kind;

  private RefusalException(Kind kind, String sentence) {
    super(sentence);
    this.kind = kind;
  }

  /** A refusal of what was asked. */
  public static RefusalException badInput(String sentence) {
    return new RefusalException(Kind.BAD_INPUT, sentence);
  }

  /** A refusal since here is nothing of the kind. */
  public static RefusalException notThere(String sentence) {
    return new RefusalException(Kind.NOT_THERE, sentence);
  }

  /** A failure outside. */
  public static RefusalException outside(String sentence) {
    return new RefusalException(Kind.OUTSIDE, sentence);
  }

  /** The same, with one sentence more. */
  public RefusalException and(String sentence) {
    RefusalException longer = new RefusalException(kind, getMessage() + " " + sentence);
    longer.initCause(this);
    return longer;
  }

  public Kind kind() {
    return kind;
  }
}
