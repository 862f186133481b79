package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;

class SetupTest {

  private static final Home BOB = Homes.home("bob");
  private static final Scene DARK = Homes.scene("bob-dark", BOB);

  private static SimulatedHome.Setup setup(Home home, Scene scene) {
    SteppedClock clock = new SteppedClock();
    InProcessBus bus = new InProcessBus(clock);
    return new SimulatedHome.Setup(home, scene, clock, 1, bus::client, "test", device -> "{}");
  }

  private static Home with(Device changed) {
    Map<String, Device> devices = new LinkedHashMap<>(BOB.devices());
    devices.put(changed.id(), changed);
    return new Home(BOB.iri(), BOB.label(), BOB.vocabulary(), BOB.individuals(), devices);
  }

  private static Device lamp(Optional<String> driver, List<FeatureType> features) {
    Device lamp = BOB.devices().get("lamp-b1");
    return new Device(lamp.individual(), lamp.container(), driver, features, lamp.reports());
  }

  @Test
  void runsOnlyTheWantedDevicesInTheWholeWorld() {
    SimulatedHome simulated = SimulatedHome.start(setup(BOB, DARK).only(Set.of("lamp-b1", "rose")));
    assertThat(simulated.devices()).containsExactly("lamp-b1", "rose");
    assertThat(simulated.world().lux("zone-a")).isGreaterThan(80);
  }

  @Test
  void leavesOutDevicesWithoutDriver() {
    Home home = with(lamp(Optional.empty(), List.of()));
    assertThat(SimulatedHome.start(setup(home, DARK)).devices()).doesNotContain("lamp-b1");
  }

  @Test
  void namesAnUnknownDriver() {
    Home home = with(lamp(Optional.of("candle"), List.of()));
    assertThatExceptionOfType(SimulationException.class)
        .isThrownBy(() -> SimulatedHome.start(setup(home, DARK)))
        .withMessageContaining("candle of lamp-b1")
        .withMessageContaining("mobile-robot");
  }

  @Test
  void namesAFeatureThatTheDriverCannotDo() {
    FeatureType pick = BOB.vocabulary().features().get("pick");
    Home home = with(lamp(Optional.of("lamp"), List.of(pick)));
    assertThatExceptionOfType(DeviceSetupException.class)
        .isThrownBy(() -> SimulatedHome.start(setup(home, DARK)))
        .withMessageContaining("lamp-b1 offers pick")
        .withMessageContaining("no MobileBase");
  }

  @Test
  void asksForTheRobotsPlace() {
    Scene scene = DARK.with("rose", Scene.Entry.NOTHING);
    assertThatExceptionOfType(SimulationException.class)
        .isThrownBy(() -> SimulatedHome.start(setup(BOB, scene)))
        .withMessageContaining("where rose stands");
  }

  @Test
  void boundsTheTimeFromBelow() {
    SimulatedHome simulated = SimulatedHome.start(setup(BOB, DARK));
    // about 1.3 m to the cup and 4.2 m on, without the reaches of 0.56 and 1.16 m, and 6 s of the
    // arm
    assertThat(simulated.lowerBound("rose", "Cup", "Bob").toMillis()).isBetween(10_000L, 12_000L);
    simulated.world().moveByHand("Cup", new Position(0.8, 2.5, 0));
    assertThat(simulated.lowerBound("rose", "Cup", "Bob")).isZero();
  }
}
