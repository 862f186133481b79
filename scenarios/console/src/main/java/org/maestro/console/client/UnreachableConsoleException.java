package org.maestro.console.client;

/** No console answers there. */
public final class UnreachableConsoleException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  UnreachableConsoleException(String at, Throwable cause) {
    super("No console answers at " + at + ".", cause);
  }
}
