package org.maestro.hal;

import java.util.List;
import java.util.Optional;

/**
 * A camera with colour-based object detection (Three-layered architecture, 4.1; M81). One that is
 * carried about turns around on the spot for a look, and has in view what it sees on the way.
 */
public interface Camera {

  /** Takes frames and says what they show; several looks may run at once. */
  void look(Target target, int frames, Listener listener);

  /** Light at an area's reference point from which the camera is specified to work; lux. */
  double minimumLux();

  /**
   * Light above which it trusts no colour; lux, infinite with one that does not notice that colours
   * are washed out.
   */
  double maximumLux();

  /**
   * The chance that one frame shows a visible object that stands in so much light, as far as the
   * camera knows.
   *
   * @return 0 to 1
   */
  double detectability(double lux);

  /** Frames a second. */
  double frameRate();

  /** Takes one picture of what is in view now; it costs the time of a frame. */
  void photograph(PhotoListener listener);

  /**
   * The same of a picture that is smaller than usual, for who needs many of them.
   *
   * @param widest pixels; the height follows
   */
  void photograph(int widest, PhotoListener listener);

  /** The share, 0 to 1, of an area's floor that a look from here and now has in view. */
  double shareInView(String area);

  /** Told once per look, unless the camera dies. */
  interface Listener {
    void looked(Look look);

    void failed(String reason);

    /** It works, and cannot say whether the thing is there; one sentence. */
    default void doubted(String reason) {
      failed(reason);
    }
  }

  /**
   * The findings of a series of frames.
   *
   * @param detections frames in which the target was detected
   * @param position mean of the detections
   * @param areas the light in the areas that the camera covers, as its images show it
   * @param glaring areas of which the images show a part over-lit, so that the camera trusts no
   *     colour; always empty with a camera that does not notice
   */
  record Look(
      int frames,
      int detections,
      Optional<Position> position,
      List<AreaLight> areas,
      List<AreaLight> glaring) {
    public Look {
      areas = List.copyOf(areas);
      glaring = List.copyOf(glaring);
    }

    /** A look in which nothing is over-lit. */
    public Look(int frames, int detections, Optional<Position> position, List<AreaLight> areas) {
      this(frames, detections, position, areas, List.of());
    }
  }

  /** Told once per picture, unless the camera dies. */
  interface PhotoListener {
    void taken(Photo photo);

    void failed(String reason);
  }

  /** The light in one covered area, at its reference point and at its extremes; lux. */
  record AreaLight(String area, double referenceLux, double darkestLux, double brightestLux) {}
}
