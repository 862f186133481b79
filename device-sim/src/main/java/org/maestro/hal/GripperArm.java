package org.maestro.hal;

import java.util.Optional;

/**
 * An arm with a {@link Hand} that holds one thing (Three-layered architecture, 4.1; M80). One
 * command runs at a time; a new one replaces the running one, whose completion is then not told.
 */
public interface GripperArm {

  /** Moves the open or closed hand to a point, at most {@link #reach} from the base's middle. */
  void extend(Position hand, Completion completion);

  void open(Completion completion);

  /** Closes the hand around the target; fails when it is not there, or the hand cannot hold it. */
  void grasp(Target target, Completion completion);

  /**
   * Whether what the hand holds has room where the hand is; a hand feels on what it sets down. True
   * when it holds nothing.
   */
  boolean isPlaceFree();

  /** Opens the hand, and what it held stays where the hand is. */
  void release(Completion completion);

  /** Brings the arm, with what it holds, into the position for driving. */
  void fold(Completion completion);

  /** Name of the thing in the hand. */
  Optional<String> held();

  /** From the base's middle to the hand, horizontally; metres. */
  double reach();

  /** Greatest mass that it lifts; kilograms. */
  double payload();

  /** The width of the widest thing that the hand takes; metres. */
  double opening();

  /** All commands of a pick-up together; seconds. */
  double pickSeconds();

  /** All commands of putting something down together; seconds. */
  double placeSeconds();

  /** Power drawn while moving; watts. */
  double power();
}
