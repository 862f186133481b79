package org.maestro.hal;

import java.util.List;
import org.maestro.ontology.floor.Point2;

/**
 * An omni-directional base: it drives along a way without turning first (Three-layered
 * architecture, 4.1; M80).
 */
public interface MobileBase {

  Point2 position();

  /** Metres a second at full speed. */
  double speed();

  /** Of the circle around base and folded arm; metres. */
  double radius();

  /** Power drawn while driving; watts. */
  double power();

  /**
   * Drives along straight pieces from where the base stands. It fails, standing still, when
   * something is in the way.
   *
   * @param way corners and end, without the present position; empty is done at once
   */
  void drive(List<Point2> way, Completion completion);

  /** Stands still at once; the completion of the drive is not told. */
  void stop();
}
