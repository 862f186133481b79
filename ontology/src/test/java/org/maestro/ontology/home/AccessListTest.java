package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.FeatureType;

/** Who may ask whom for what, as a home states it. */
class AccessListTest {
  private static String bob;

  @BeforeAll
  static void read() throws IOException {
    bob = Files.readString(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
  }

  private static Home home(String... permissions) {
    return new HomeLoader().load(bob + String.join("\n", permissions), "bob.ttl");
  }

  private static String fault(String permission) {
    return catchThrowableOfType(HomeFaultException.class, () -> home(permission)).getMessage();
  }

  @Test
  void aHomeThatStatesNothingIsOpen() {
    Home home = home();
    AccessList open = AccessList.of(home);
    assertThat(open.isOpen()).isTrue();
    assertThat(open.objection(Set.of("anyone"), home.devices().get("rose"), "pick")).isEmpty();
    assertThat(open.knows(Set.of("anyone"))).isTrue();
  }

  /** Who may ask what is known need not be one who tells it (ADE, 3.1; A29). */
  @Test
  void aPartThatIsOpenedToSomeIsClosedToOthersAndFeaturesStayAsTheyWere() {
    Home home =
        home(
            "home:p1 a maestro:Permission ; maestro:caller \"nurse\" ; maestro:asks home:rose ;"
                + " maestro:opens maestro:memory .");
    PartList parts = PartList.of(home);
    assertThat(AccessList.of(home).isOpen()).isTrue();
    assertThat(parts.objection(Set.of("nurse"), "rose", Part.MEMORY)).isEmpty();
    assertThat(parts.objection(Set.of("thief"), "rose", Part.MEMORY))
        .contains("no maestro:Permission of the home opens the memory of rose to thief");
    assertThat(parts.objection(Set.of("thief"), "lamp-a1", Part.MEMORY)).isEmpty();
    assertThat(parts.objection(Set.of("thief"), "rose", Part.TELLING)).isEmpty();
  }

  @Test
  void aPartThatThereIsNotIsAFault() {
    assertThat(
            fault(
                "home:p a maestro:Permission ; maestro:caller \"nurse\" ;"
                    + " maestro:opens maestro:memroy ."))
        .contains("memroy", "write memory, if that is meant");
  }

  /**
   * Different rights for each component (ADE, 3.1; A29): all pairs of three callers, devices,
   * features.
   */
  @Test
  void whatNoPermissionAllowsIsRefused() {
    Home home =
        home(
            "home:p1 a maestro:Permission ; maestro:caller \"tablet\" ; maestro:asks :Lamp .",
            "home:p2 a maestro:Permission ; maestro:caller \"nurse\", \"desk\" ;"
                + " maestro:asks home:rose, home:lamp-b1 ; maestro:permits :pick, :adjustLight .",
            "home:p3 a maestro:Permission ; maestro:caller \"*\" ;"
                + " maestro:permits :measureIllumination .");
    AccessList access = AccessList.of(home);
    List<String> allowed =
        Stream.of("tablet", "nurse", "thief")
            .flatMap(
                caller ->
                    Stream.of("lamp-a1", "lamp-b1", "rose")
                        .map(home.devices()::get)
                        .flatMap(
                            device ->
                                Stream.of("adjustLight", "pick", "measureIllumination")
                                    .filter(
                                        feature ->
                                            access
                                                .objection(Set.of(caller), device, feature)
                                                .isEmpty())
                                    .map(feature -> caller + " " + device.id() + " " + feature)))
            .filter(line -> !line.endsWith("measureIllumination"))
            .toList();
    assertThat(allowed)
        .containsExactly(
            "tablet lamp-a1 adjustLight",
            "tablet lamp-a1 pick",
            "tablet lamp-b1 adjustLight",
            "tablet lamp-b1 pick",
            "nurse lamp-b1 adjustLight",
            "nurse lamp-b1 pick",
            "nurse rose adjustLight",
            "nurse rose pick");
    assertThat(access.objection(Set.of("thief"), home.devices().get("rose"), "measureIllumination"))
        .isEmpty();
    assertThat(access.objection(Set.of("thief"), home.devices().get("rose"), "pick"))
        .contains("no maestro:Permission of the home lets thief ask rose for pick");
    assertThat(access.objection(Set.of("cli-7", "nurse"), home.devices().get("rose"), "pick"))
        .isEmpty();
    assertThat(home.devices().get("rose").features())
        .extracting(FeatureType::name)
        .contains("pick");
  }

  @Test
  void aTypingErrorIsAFaultAndOpensNothing() {
    assertThat(
            fault(
                "home:p a maestro:Permission ; maestro:caller \"x\" ; maestro:asks home:lamp-b7 ."))
        .contains("p maestro:asks lamp-b7 is neither a device of this home nor a class of devices");
    assertThat(
            fault(
                "home:p a maestro:Permission ; maestro:caller \"x\" ; maestro:permits :adjustLigth"
                    + " ."))
        .contains("p maestro:permits adjustLigth is no feature that is known here")
        .contains("adjustLight");
    assertThat(fault("home:p a maestro:Permission ; maestro:asks home:rose ."))
        .contains("maestro:caller is missing");
    assertThat(fault("home:p a maestro:Permission ; maestro:caller \"a b\" ."))
        .contains("is no name of an agent or user");
  }
}
