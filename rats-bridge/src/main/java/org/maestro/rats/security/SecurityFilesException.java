package org.maestro.rats.security;

/**
 * A site's security files are missing, cannot be read or written, are open to others, or say what
 * cannot be. The message is one sentence that names the file and the cure; it holds no secret.
 */
public final class SecurityFilesException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  SecurityFilesException(String message) {
    super(message);
  }

  SecurityFilesException(String message, Throwable cause) {
    super(message, cause);
  }
}
