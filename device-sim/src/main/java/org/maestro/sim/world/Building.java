package org.maestro.sim.world;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;

/** Floor, walls and doors, of which each is open or closed. Any thread may call it. */
public final class Building {

  private final FloorMap map;
  private volatile State state;

  /** The state of the doors, and the floor plan and walls that go with it. */
  private record State(Set<String> openDoors, FloorPlan plan, List<Segment> walls) {
    static State of(FloorMap map, Set<String> openDoors) {
      FloorPlan plan = map.plan(openDoors);
      return new State(openDoors, plan, FloorMap.walls(plan));
    }
  }

  Building(Home home, Scene scene) {
    this.map = new FloorMap(home);
    Set<String> open = new TreeSet<>(map.doors().keySet());
    open.removeIf(door -> !scene.of(door).open().orElse(true));
    this.state = State.of(map, open);
  }

  public FloorMap map() {
    return map;
  }

  /** Walls with openings where doors are open. */
  public FloorPlan plan() {
    return state.plan();
  }

  /** Each wall and closed door once. */
  public List<Segment> walls() {
    return state.walls();
  }

  boolean isOpen(String door) {
    return state.openDoors().contains(door);
  }

  /**
   * @throws SimulationException when there is no such door
   */
  synchronized void setDoor(String door, boolean open) {
    if (!map.doors().containsKey(door)) {
      throw new SimulationException(
          "There is no door " + door + "; there are " + map.doors().keySet());
    }
    Set<String> openDoors = new TreeSet<>(state.openDoors());
    if (open) {
      openDoors.add(door);
    } else {
      openDoors.remove(door);
    }
    state = State.of(map, openDoors);
  }
}
