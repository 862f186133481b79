package org.maestro.knowledge.api;

/**
 * What was said cannot be kept or asked. The message says what, by whom, and what would be right.
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
