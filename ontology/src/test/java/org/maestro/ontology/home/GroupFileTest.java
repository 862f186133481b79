package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Files that bring a room's agent and its devices into a home that runs (A96). */
class GroupFileTest {
  private static final String HEARS = "maestro:hears home:room-a";
  private static final String EARS =
      """
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/bob#> .
      home:ears a maestro:RoomAgent ; rdfs:label "the ears of A" ; maestro:hears home:room-a ;
        maestro:memberWhen "(inside ?member zone-a)" ; maestro:member home:lamp-a1 ;
        maestro:understands :lights .
      """;
  private static final String LAMP =
      """
      home:lamp-9 a :Lamp ; maestro:pose "1 1 2.8" ; maestro:luminousIntensity 600 ;
        maestro:beamAngle 100 ; :power 5 .
      """;

  private static final Home BOB = new HomeLoader().load(ShippedHomes.text("bob.ttl"), "bob.ttl");

  private static GroupFile.Parts read(String text) {
    return new GroupFile(BOB).read(text, "room.ttl");
  }

  @Test
  void anAgentIsReadAndItsDevicesAreLeftToWhoReadsDevices() {
    GroupFile.Parts parts = read(EARS + LAMP);

    assertThat(parts.groups()).extracting(Group::id).containsExactly("ears");
    assertThat(parts.groups().get(0).hearing().orElseThrow().topics()).containsExactly("lights");
    assertThat(parts.devices()).contains("lamp-9").doesNotContain("ears");
    assertThat(read(EARS).devices()).isBlank();
  }

  @Test
  void whatDescribesNoGroupIsLeftAsItIs() {
    String lamp = EARS.substring(0, EARS.indexOf("home:ears")) + LAMP;

    assertThat(read(lamp)).isEqualTo(new GroupFile.Parts(List.of(), lamp));
  }

  @Test
  void whatIsWrongWithOneIsToldWithItsLine() {
    assertWrong(EARS.replace(HEARS + " ;", ""), "room.ttl:5: ears maestro:hears is not stated");
    assertWrong(EARS.replace(HEARS, "maestro:hears home:lamp-a1"), "is no room");
    assertWrong(
        EARS.replace("understands :lights", "understands :lihgts"),
        "names lihgts, which is neither a topic nor a construction");
    assertWrong(EARS.replace("home:ears", "home:rose"), "has the name of something else");
    assertWrong(EARS.replace("(inside ?member", "(insied ?member"), "insied");
    Home heard = BOB.with(read(EARS).groups().get(0));
    assertThatThrownBy(
            () -> new GroupFile(heard).read(EARS.replace("home:ears", "home:nose"), "room.ttl"))
        .hasMessageContaining("is a room in which ears hears what is said");
  }

  private static void assertWrong(String text, String message) {
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining(message);
  }
}
