package org.maestro.random;

import java.util.ArrayList;
import java.util.List;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;

/** Rooms side by side in one or two rows, and doors in the walls between them. */
final class FloorDraft {
  private static final double DOOR_WIDTH = 0.9;
  private static final double DOOR_FROM_CORNER = 0.4;
  private static final int PLACES_TRIED = 60;

  /** A room, which is a zone too: {@code zone-a} in {@code room-a}. */
  record Room(int column, int row, String letter, double x, double y, double width, double depth) {
    String zone() {
      return "zone-" + letter;
    }

    Point2 middle() {
      return new Point2(
          Math.round(100 * (x + width / 2)) / 100.0, Math.round(100 * (y + depth / 2)) / 100.0);
    }
  }

  /** An opening between two rooms. */
  record Door(String name, Room first, Room second, Point2 from, Point2 to, Kind kind) {
    Point2 middle() {
      return new Point2((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
    }
  }

  /** The kind of a door: whether it is open, driven or locked. */
  enum Kind {
    OPEN,
    SHUT,
    DRIVEN_OPEN,
    DRIVEN_SHUT,
    DRIVEN_LOCKED;

    boolean isOpen() {
      return this == OPEN || this == DRIVEN_OPEN;
    }

    boolean isDriven() {
      return this == DRIVEN_OPEN || this == DRIVEN_SHUT || this == DRIVEN_LOCKED;
    }
  }

  /** Something that stands somewhere. */
  private record Standing(Point2 place, double radius) {}

  private final Chance chance;
  private final List<Room> rooms = new ArrayList<>();
  private final List<Door> doors = new ArrayList<>();
  private final List<Standing> taken = new ArrayList<>();

  FloorDraft(Chance chance) {
    this.chance = chance;
    drawRooms();
    for (Room room : rooms) {
      rooms.stream().filter(other -> isRightOf(other, room)).forEach(o -> drawDoor(room, o));
      rooms.stream().filter(other -> isAbove(other, room)).forEach(o -> drawDoor(room, o));
    }
  }

  private void drawRooms() {
    int count = chance.oneOf(List.of(1, 2, 2, 2, 3, 3, 3, 4, 4, 5, 6));
    int columns = count <= 3 ? count : (count + 1) / 2;
    double[] widths = new double[columns];
    for (int column = 0; column < columns; column++) {
      widths[column] = chance.number(2.8, 3.8);
    }
    double[] depths = {chance.number(2.8, 3.8), chance.number(2.8, 3.8)};
    for (int i = 0; i < count; i++) {
      int column = i % columns;
      int row = i / columns;
      double x = 0;
      for (int before = 0; before < column; before++) {
        x += widths[before];
      }
      rooms.add(
          new Room(
              column,
              row,
              String.valueOf((char) ('a' + i)),
              Math.round(100 * x) / 100.0,
              row * depths[0],
              widths[column],
              depths[row]));
    }
  }

  private static boolean isRightOf(Room other, Room room) {
    return other.row() == room.row() && other.column() == room.column() + 1;
  }

  private static boolean isAbove(Room other, Room room) {
    return other.column() == room.column() && other.row() == room.row() + 1;
  }

  private void drawDoor(Room first, Room second) {
    if (chance.happens(0.12)) {
      return;
    }
    boolean sideBySide = first.row() == second.row();
    double length = sideBySide ? first.depth() : first.width();
    double begin = chance.number(DOOR_FROM_CORNER, length - DOOR_FROM_CORNER - DOOR_WIDTH);
    Point2 from =
        sideBySide
            ? new Point2(second.x(), first.y() + begin)
            : new Point2(first.x() + begin, second.y());
    Point2 to =
        sideBySide
            ? new Point2(from.x(), from.y() + DOOR_WIDTH)
            : new Point2(from.x() + DOOR_WIDTH, from.y());
    Kind kind =
        chance.oneOf(
            List.of(
                Kind.OPEN,
                Kind.OPEN,
                Kind.OPEN,
                Kind.OPEN,
                Kind.OPEN,
                Kind.OPEN,
                Kind.SHUT,
                Kind.DRIVEN_OPEN,
                Kind.DRIVEN_SHUT,
                Kind.DRIVEN_SHUT,
                Kind.DRIVEN_LOCKED));
    String name = "door-" + first.letter() + second.letter();
    doors.add(new Door(name, first, second, from, to, kind));
  }

  List<Room> rooms() {
    return List.copyOf(rooms);
  }

  List<Door> doors() {
    return List.copyOf(doors);
  }

  Room anyRoom() {
    return chance.oneOf(rooms);
  }

  /**
   * A place in the room for something of this radius: off the walls, off what stands there, and not
   * in a doorway.
   */
  Position place(Room room, double radius, double fromWall) {
    Position place = free(room, radius, fromWall);
    taken.add(new Standing(place.floor(), radius));
    return place;
  }

  /** The same for what may be there later: it takes no place from others. */
  Position free(Room room, double radius, double fromWall) {
    Point2 best = room.middle();
    double bestClearance = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < PLACES_TRIED && bestClearance < 0; i++) {
      Point2 place =
          new Point2(
              chance.number(room.x() + fromWall, room.x() + room.width() - fromWall),
              chance.number(room.y() + fromWall, room.y() + room.depth() - fromWall));
      double clearance = clearance(place, radius);
      if (clearance > bestClearance) {
        best = place;
        bestClearance = clearance;
      }
    }
    return Position.onFloor(best);
  }

  private double clearance(Point2 place, double radius) {
    double clearance = Double.POSITIVE_INFINITY;
    for (Standing other : taken) {
      clearance =
          Math.min(clearance, other.place().distance(place) - other.radius() - radius - 0.1);
    }
    for (Door door : doors) {
      clearance = Math.min(clearance, door.middle().distance(place) - 0.75 - radius);
    }
    return clearance;
  }
}
