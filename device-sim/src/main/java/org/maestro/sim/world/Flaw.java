package org.maestro.sim.world;

/** A silent fault of a device: what it does of what it is told, and what it tells. */
public enum Flaw {
  /** It does what it says. */
  NONE,
  /** It says that it is done, does nothing, and goes on telling its state as it is. */
  IDLE,
  /** It says that it is done, does nothing, and tells the state that it was to be in. */
  BOASTING,
  /** It goes half of the way, and tells the state that it was to be in. */
  HALF,
  /** A sensor goes on showing what it showed last. */
  STUCK,
  /** A base says that it has driven, stays where it is, and tells where that is. */
  STANDING,
  /** A base says that it has driven, stays where it is, and believes to be where it was to go. */
  SPINNING,
  /** A camera sees nothing of what is there. */
  BLIND,
  /** A camera sees whatever it is asked for where its view begins, unless it really sees it. */
  SEEING_THINGS;

  public boolean isIdle() {
    return this == IDLE || this == BOASTING;
  }

  /** Whether it stays where it is when it is told to drive. */
  public boolean isStranded() {
    return this == STANDING || this == SPINNING;
  }

  /** Whether it tells what it was told as its state. */
  public boolean repeatsOrders() {
    return this == BOASTING || this == HALF;
  }

  /** How far it comes when it is told to go from one value to another. */
  public double reached(double from, double to) {
    return isIdle() ? from : this == HALF ? (from + to) / 2 : to;
  }
}
