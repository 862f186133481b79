package org.maestro.random;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

class BuildingTest {
  private static final Pattern SIDES = Pattern.compile(":side home:(z\\d+) , home:(z\\d+)");

  @ParameterizedTest
  @CsvSource({"1, 1", "40, 1", "40, 2", "100, 3", "200, 2"})
  void hasAboutSoManyDevicesAndIsALoadableHomeWithItsScene(int devices, int floors) {
    Building building = new Building(devices, floors, 7);
    Home home = new HomeLoader().load(building.homeText(), "building.ttl");

    assertThat(building.devices()).isCloseTo(Math.max(5, devices), within(5 * floors));
    assertThat(home.devices()).hasSize(building.devices());
    SceneLoader.load(
        "scene.ttl",
        new ByteArrayInputStream(building.sceneText().getBytes(StandardCharsets.UTF_8)),
        home);
  }

  @ParameterizedTest
  @CsvSource({"100, 1, 1", "200, 2, 2", "400, 3, 3", "1000, 4, 4"})
  void everyRoomIsReachedFromEveryOther(int devices, int floors, long seed) {
    Building building = new Building(devices, floors, seed);
    List<List<String>> doors =
        SIDES
            .matcher(building.homeText())
            .results()
            .map(door -> List.of(door.group(1), door.group(2)))
            .toList();
    Set<String> reached = new TreeSet<>(Set.of("z0"));
    Deque<String> open = new ArrayDeque<>(reached);
    while (!open.isEmpty()) {
      String zone = open.remove();
      doors.stream()
          .filter(door -> door.contains(zone))
          .flatMap(List::stream)
          .filter(reached::add)
          .forEach(open::add);
    }

    assertThat(reached).hasSize(building.rooms());
  }

  @Test
  void oneSeedMakesOneBuilding() {
    Building one = new Building(100, 2, 3);
    Building same = new Building(100, 2, 3);
    Building other = new Building(100, 2, 4);

    assertThat(same.homeText() + same.sceneText()).isEqualTo(one.homeText() + one.sceneText());
    assertThat(other.homeText()).isNotEqualTo(one.homeText());
  }
}
