package org.maestro.hal;

/**
 * A bag of grains that is soft while air is in it and stiff without (Brown et al., "Universal
 * robotic gripper based on the jamming of granular material", PNAS 2010; Three-layered
 * architecture, 4.1; M80). One command runs at a time. Clock thread.
 */
public interface JammingGripper {

  /** Presses the soft bag upon what lies below, so that it flows around it. */
  void press(Completion completion);

  /**
   * Pumps the air out of the pressed bag, until it is stiff and holds what it has wrapped; fails
   * when it holds nothing then.
   */
  void evacuate(Completion completion);

  /**
   * Softens the bag by positive pressure, which pushes out what it held; fails when nothing was in
   * it, and when there is no room for it, which then stays in the stiff bag.
   */
  void inflate(Completion completion);

  /** Ends the running command, whose completion is then not told; the bag keeps its pressure. */
  void stop();

  /** In the bag, against the air's; kilopascals, below 0 while it is evacuated. */
  double pressure();

  /** Whether the bag is stiff. */
  boolean isEvacuated();

  /** Whether the stiff bag holds something. */
  boolean isHolding();

  /** The width of the widest thing that the bag gets around; metres. */
  double opening();

  /** Pressing and evacuating together; seconds. */
  double gripSeconds();

  /** Softening the bag again; seconds. */
  double inflateSeconds();
}
