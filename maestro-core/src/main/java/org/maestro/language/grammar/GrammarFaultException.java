package org.maestro.language.grammar;

/**
 * A grammar's file says what cannot be read; the message tells the line, the cause and the cure.
 */
public final class GrammarFaultException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public GrammarFaultException(String file, int line, String problem, String cure) {
    super("%s:%d: %s; %s.".formatted(file, line, problem, cure));
  }
}
