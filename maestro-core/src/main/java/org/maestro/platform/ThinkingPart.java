package org.maestro.platform;

/**
 * A part of the central agent that may be an agent itself, in a process of its own (ADE, 3; A15).
 */
public enum ThinkingPart {
  /** Understands what people say. */
  LANGUAGE,
  /** Pursues goals that it is asked for, with all devices of the home. */
  GOALS
}
