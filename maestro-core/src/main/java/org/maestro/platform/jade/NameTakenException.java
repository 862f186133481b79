package org.maestro.platform.jade;

/** A container could not join, as another of the platform has its name. */
public final class NameTakenException extends PlatformStartException {
  private static final long serialVersionUID = 1L;

  /**
   * @param container as its user calls it
   */
  public NameTakenException(String container) {
    super("The platform has a container %s already; choose another --name.".formatted(container));
  }
}
