package org.maestro.coordination.contention;

/**
 * Who contends for what members have: a goal of this coordinator, or one of another manager as this
 * one sees it. The coordinator's thread only.
 */
interface Contender {

  String id();

  /** Begins what may begin; what it waits for may have become free. */
  void advance();

  /** Its steps that run, as far as they are known here. */
  StepsUnderway underway();

  /** Whether the member carries something for it. */
  boolean isTied(String member);

  /** What its plan may yet take. */
  double remainingSeconds();

  double secondsOfRunningSteps();

  /** Another goes first, and asks for what this one keeps. */
  void giveWayTo(String other);

  /** It rests until the other is over, and lets go even of what it carries. */
  void stepBackFor(String other);
}
