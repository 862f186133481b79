package org.maestro.hal;

/** An end effector that holds one thing. One command runs at a time. Clock thread. */
public interface Hand {

  /** Makes it ready to take something. */
  void open(Completion completion);

  /** Takes what lies at it, and fails when it does not hold that then. */
  void close(Completion completion);

  /** Lets go of what it holds, and fails when it holds nothing or there is no room. */
  void letGo(Completion completion);

  /** Ends the running command, whose completion is then not told. */
  void stop();

  /** The width of the widest thing that it takes; metres. */
  double opening();

  double closeSeconds();

  double letGoSeconds();
}
