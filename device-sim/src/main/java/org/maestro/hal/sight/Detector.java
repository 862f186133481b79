package org.maestro.hal.sight;

import boofcv.struct.image.GrayU8;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;

/**
 * Detection by colour and size (Three-layered architecture, 4.1; M81). Pixels whose chromaticity is
 * near that of the wanted thing and that hang together are taken for it where there are about as
 * many of them as it would fill from where they seem to be. What has no colour of its own is not
 * told from a grey floor.
 *
 * @param tolerance distance in chromaticity that still is the same colour
 * @param takesAll whether pixels that are at their end count as well, of which the colour is not
 *     known
 */
public record Detector(double tolerance, boolean takesAll) {

  /** Pixels that are darker have no colour to go by; share of the end, mean of the channels. */
  private static final double DARK = 0.005;

  /** How many tolerances a colour is from grey: floors are not quite grey either. */
  private static final double COLOURED = 1.5;

  /** Around a place so many times a thing's breadth are looked at, to each side. */
  private static final double AROUND = 1.5;

  /** More coloured pixels than this share may hide something. */
  private static final double SOME = 0.2;

  /** With more bare pixels than this share nothing stands there. */
  private static final double MOST = 0.75;

  /** As far from the dark and from the end all colours are known; share of the end. */
  private static final double CLEAR = 0.05;

  /** A channel from here on may be at its end. */
  private static final int END = 254;

  /** Fewer pixels may be noise. */
  private static final int FEWEST_PIXELS = 6;

  /** A thing fills at least this share of what it would fill alone, or exceeds it as much. */
  private static final double LEAST_FIT = 0.35;

  /** Of two things of one colour the size tells which it is if one of them is so much smaller. */
  private static final double SAME_SIZE = 0.7;

  private static final int CHANNELS = 3;
  private static final int CHANNEL = 0xff;

  /** Whether its colour tells it from floors and walls, which have none. */
  public boolean hasColour(Appearance wanted) {
    return wanted.paint().distance(Paint.GREY) >= COLOURED * tolerance;
  }

  /**
   * All that may be the wanted thing, the likeliest first.
   *
   * @param others looks of what may be in view as well: what fits one of them better is not it
   */
  public List<Sighting> find(
      Photo photo, Lens lens, Appearance wanted, Collection<Appearance> others) {
    List<Appearance> rivals =
        others.stream()
            .filter(other -> isOfOneColour(wanted, other) && !isOfOneSize(wanted, other))
            .toList();
    List<Sighting> found = new ArrayList<>();
    for (Blob blob : Blobs.of(coloured(photo, wanted.paint()), FEWEST_PIXELS)) {
      Optional<Sighting> here =
          sighting(blob, lens, wanted).filter(seen -> seen.confidence() >= LEAST_FIT);
      if (here.isPresent()
          && rivals.stream()
              .flatMap(rival -> sighting(blob, lens, rival).stream())
              .noneMatch(rival -> rival.confidence() > here.get().confidence())) {
        found.add(here.get());
      }
    }
    found.sort((one, other) -> Double.compare(other.confidence(), one.confidence()));
    return found;
  }

  private static Optional<Sighting> sighting(Blob blob, Lens lens, Appearance thing) {
    return lens.at(blob.column(), blob.row(), thing.size().height() / 2)
        .map(
            middle -> {
              Position foot = Position.onFloor(middle.floor());
              double fit = blob.pixels() / pixels(lens, thing, foot);
              return new Sighting(foot, Math.min(fit, 1 / fit));
            });
  }

  /** Whether it is large enough to be found there. */
  public boolean isLargeEnough(Lens lens, Appearance wanted, Position foot) {
    return LEAST_FIT * pixels(lens, wanted, foot) >= FEWEST_PIXELS;
  }

  /** What a picture shows of a place at which the wanted thing is not found. */
  public enum Place {
    /** The floor, so that it is not there. */
    FREE,
    /** Something else, which may hide it. */
    COVERED,
    /** Nothing that one could go by: it is beyond the edge, too far, dark or at its end. */
    UNSEEN
  }

  /** What a picture shows of the place at which a thing stood. */
  public Place place(Photo photo, Lens lens, Appearance wanted, Position foot) {
    Optional<Lens.Pixel> pixel = lens.pixel(wanted.middle(foot));
    if (pixel.isEmpty() || !isLargeEnough(lens, wanted, foot)) {
      return Place.UNSEEN;
    }
    int reach = (int) Math.ceil(AROUND * Math.sqrt(pixels(lens, wanted, foot)));
    int all = 0;
    int bare = 0;
    int covered = 0;
    for (int row = -reach; row <= reach; row++) {
      for (int column = -reach; column <= reach; column++) {
        Paint seen = seen(photo, pixel.get().column() + column, pixel.get().row() + row);
        double mean = (seen.red() + seen.green() + seen.blue()) / CHANNELS;
        boolean isGrey = seen.distance(Paint.GREY) < COLOURED * tolerance;
        all++;
        bare += isGrey && mean >= CLEAR && mean <= 1 - CLEAR ? 1 : 0;
        covered += !isGrey && mean >= CLEAR ? 1 : 0;
      }
    }
    if (covered > SOME * all) {
      return Place.COVERED;
    }
    return bare > MOST * all ? Place.FREE : Place.UNSEEN;
  }

  /** Black beyond the edge. */
  private static Paint seen(Photo photo, int column, int row) {
    return column < 0 || row < 0 || column >= photo.width() || row >= photo.height()
        ? Paint.ofPixel(0)
        : Paint.ofPixel(photo.at(column, row));
  }

  /** Whether neither colour nor size tells one from the other. */
  public boolean areAlike(Appearance one, Appearance other) {
    return isOfOneColour(one, other) && isOfOneSize(one, other);
  }

  private boolean isOfOneColour(Appearance one, Appearance other) {
    return one.paint().distance(other.paint()) < 2 * tolerance;
  }

  private static boolean isOfOneSize(Appearance one, Appearance other) {
    double share = one.size().outline() / other.size().outline();
    return Math.min(share, 1 / share) >= SAME_SIZE;
  }

  private static double pixels(Lens lens, Appearance wanted, Position foot) {
    Vector towards = wanted.middle(foot).plus(lens.place(), -1);
    return lens.pixels(wanted.area(towards), towards);
  }

  private GrayU8 coloured(Photo photo, Paint wanted) {
    GrayU8 coloured = new GrayU8(photo.width(), photo.height());
    int[] rgb = photo.rgb();
    for (int i = 0; i < rgb.length; i++) {
      Paint seen = Paint.ofPixel(rgb[i]);
      boolean known =
          (takesAll || !isAtEnd(rgb[i]))
              && seen.red() + seen.green() + seen.blue() >= CHANNELS * DARK;
      coloured.data[i] = (byte) (known && seen.distance(wanted) < tolerance ? 1 : 0);
    }
    return coloured;
  }

  private static boolean isAtEnd(int rgb) {
    return (rgb >> 2 * Byte.SIZE & CHANNEL) >= END
        || (rgb >> Byte.SIZE & CHANNEL) >= END
        || (rgb & CHANNEL) >= END;
  }
}
