package org.maestro.rats.protocol;

import java.util.Optional;

/** The features that every member understands, whatever its own are. */
public enum ReservedFeature {
  /**
   * Ends the call {@code {"id": ...}}, by its caller or a controller (Three-layered architecture,
   * 3.2.1; M42).
   */
  CANCEL("$cancel"),
  /**
   * Ends everything and brings the member into a safe state (Three-layered architecture, 3.2.1;
   * M37).
   */
  SAFE("$safe"),
  /** Asks for prices, see {@link CostExchange} (Three-layered architecture, 3.2.2; M54). */
  COST("$cost"),
  /** Publishes description, state and status again. */
  DESCRIBE("$describe"),
  PING("$ping");

  /**
   * From a member to the holder of a contract: it could do a task too (Three-layered architecture,
   * 3.2.1; M43).
   */
  public static final String OFFER = "$offer";

  /**
   * From a member to the holder of a contract: it gives a task back (Three-layered architecture,
   * 3.2.1; M44).
   */
  public static final String RELEASE = "$release";

  /** The stream of what people should hear of at once. */
  public static final String ALERT = "$alert";

  private final String word;

  ReservedFeature(String word) {
    this.word = word;
  }

  /** The feature's id in a call. */
  public String word() {
    return word;
  }

  /** Whether it changes nothing on the member. */
  public boolean isQuestion() {
    return this == COST || this == DESCRIBE || this == PING;
  }

  public static Optional<ReservedFeature> of(String feature) {
    for (ReservedFeature reserved : values()) {
      if (reserved.word.equals(feature)) {
        return Optional.of(reserved);
      }
    }
    return Optional.empty();
  }
}
