package org.maestro.coordination.api;

/**
 * The reason why an answer to a question of a script is not taken.
 *
 * @param reason one sentence
 * @param isOpen whether the question still waits for an answer
 */
public record AnswerRefusal(String reason, boolean isOpen) {

  /** Nobody waits for an answer to that. */
  public static AnswerRefusal notOpen(String part) {
    return new AnswerRefusal(
        "There is no open question %s; ./maestro goals shows who waits for an answer."
            .formatted(part),
        false);
  }
}
