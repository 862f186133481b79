package org.maestro.bench.losses;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** A loss that strikes while a goal is pursued. */
public enum Loss {
  NONE("nothing"),
  KILLED("a container's process killed"),
  FROZEN("a container's process frozen"),
  CUT("a host cut off for 10 s"),
  SLOW("a host's link slowed to 1 Mbit/s"),
  ALL_BUT_ONE("all hosts but the platform's own"),
  MAIN("the platform's process killed"),
  FROZEN_MAIN("the platform's process frozen");

  private final String inWords;

  Loss(String inWords) {
    this.inWords = inWords;
  }

  public String inWords() {
    return inWords;
  }

  /** As people write it, such as {@code all-but-one}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  public static Optional<Loss> of(String word) {
    return Arrays.stream(values()).filter(loss -> loss.word().equals(word)).findFirst();
  }

  boolean isOfMain() {
    return this == MAIN || this == FROZEN_MAIN;
  }

  /** Whether a link is disturbed, which needs hosts with addresses of their own. */
  public boolean isOfLinks() {
    return this == CUT || this == SLOW;
  }

  /** Whether containers are given up. */
  boolean isOfContainers() {
    return this == KILLED || this == FROZEN || this == CUT || this == ALL_BUT_ONE;
  }
}
