package org.maestro.knowledge.api;

/**
 * A statement that cannot be kept, or a question that cannot be asked. The message says what, by
 * whom, and what would be right.
 */
public final class KnowledgeException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  public KnowledgeException(String message) {
    super(message);
  }

  public KnowledgeException(String message, Throwable cause) {
    super(message, cause);
  }
}
