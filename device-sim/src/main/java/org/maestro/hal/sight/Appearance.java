package org.maestro.hal.sight;

import java.util.Collection;
import java.util.Optional;
import org.maestro.hal.Position;

/**
 * The looks by which a thing is found.
 *
 * @param paint colour of its surface
 * @param size of the box around it
 */
public record Appearance(Paint paint, Size size) {

  /**
   * As texts that are stated of a thing read: the name of a colour or {@code #a03020}, and three
   * lengths. Empty when there is no such colour or no such size.
   */
  public static Optional<Appearance> read(Collection<String> texts) {
    Optional<Paint> paint = texts.stream().flatMap(text -> Paint.parse(text).stream()).findFirst();
    Optional<Size> size = texts.stream().flatMap(text -> Size.parse(text).stream()).findFirst();
    return paint.isPresent() && size.isPresent()
        ? Optional.of(new Appearance(paint.get(), size.get()))
        : Optional.empty();
  }

  /** Where its middle is when its foot is there. */
  Vector middle(Position foot) {
    return new Vector(foot.x(), foot.y(), foot.z() + size.height() / 2);
  }

  /**
   * The area that is seen of it, upright and turned in any way; square metres.
   *
   * @param towards from the one who sees it to its middle
   */
  double area(Vector towards) {
    double far = towards.length();
    double steep = Math.abs(towards.z()) / far;
    double level = Math.hypot(towards.x(), towards.y()) / far;
    // the mean breadth of an outline is its circumference over pi
    double breadth = 2 * (size.length() + size.width()) / Math.PI;
    return steep * size.length() * size.width() + level * breadth * size.height();
  }
}
