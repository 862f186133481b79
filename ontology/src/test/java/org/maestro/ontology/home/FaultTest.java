package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.validation.Fault;

class FaultTest {

  private static final String BOB = ShippedHomes.text("bob.ttl");

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "maestro:luminousIntensity 505 | maestro:luminousIntensity \"abc\""
            + " | lamp-b1 maestro:luminousIntensity \"abc\" is not a number from 0;"
            + " write candela, such as 300",
        "\"4.5 1.5 2.8\" ; maestro:viewAngle 75 | \"4.5 1.5 2.8\" ; maestro:viewAngle 190"
            + " | cam-b maestro:viewAngle \"190\" is not a number above 0 and up to 180",
        "\"4.5 1.5 2.8\" ; maestro:viewAngle 75 |"
            + " \"4.5 1.5 2.8\" ; maestro:viewAngle 75 ; maestro:frameRate 0"
            + " | cam-b maestro:frameRate \"0\" is not a number above 0; write images each second",
        "\"4.5 1.5 2.8\" ; maestro:viewAngle 75 |"
            + " \"4.5 1.5 2.8\" ; maestro:viewAngle 75 ; maestro:resolution \"wide\""
            + " | cam-b maestro:resolution \"wide\" is no width and height; write both in pixels",
        ":power 17 | :power \"much\" | lamp-b2 :power \"much\" is not a number; write a number in"
            + " W",
        ":power 17 | :power -17 | lamp-b2 :power \"-17\" is less than a power can be; write 0 W or"
            + " more",
        ":mass 0.25 | :mass -0.25 | Cup :mass \"-0.25\" is less than a mass can be; write 0 kg or"
            + " more",
        ":speed 0.8 | :speed -0.8 | rose :speed \"-0.8\" is less than a speed can be; write 0 m/s",
        ":payload 0.5 | :payload -1 | rose :payload \"-1\" is less than a payload can be",
        ":gripperOpening 0.098 | :gripperOpening -0.1"
            + " | rose :gripperOpening \"-0.1\" is less than a gripper opening can be; write 0 m",
        "home:cam-b a :Camera | home:cam-b :minimumIlluminance -1 ; a :Camera"
            + " | cam-b :minimumIlluminance \"-1\" is less than a minimum illuminance can be",
        ":size \"0.08 0.08 0.1\" | :size \"-0.08 0.08 0.1\""
            + " | Cup :size \"-0.08 0.08 0.1\" is less than a width can be; write 0 m or more",
        ":size \"0.08 0.08 0.1\" | :size \"small\" | Cup :size \"small\" does not tell the width",
        ":power 17 | :power 17 ; :level 0.5 | lamp-b2 :level is for the device itself to tell,"
            + " whatever a home states; remove it; how it is at first",
        ":speed 0.8 | :speed 0.8 ; :charge 0.5 | rose :charge is for the device itself to tell",
        ":speed 0.8 | :speed 0.8 ; maestro:position \"1 1 0\""
            + " | rose maestro:position is for the device itself to tell",
        ":side home:zone-a , home:zone-b | a :DrivenDoor ; :side home:zone-a , home:zone-b"
            + " | door-ab :open is for the device itself to tell",
        ":usuallyIn home:zone-a | :usuallyIn home:zone-c"
            + " | Bob :usuallyIn zone-c is not described in this home",
        ":usuallyIn home:zone-a | :usuallyIn home:door-ab | Bob :usuallyIn door-ab is no Place",
        ":usuallyIn home:zone-a | :usualyIn home:zone-a"
            + " | Bob :usualyIn is no known property; write :usuallyIn, if that is meant",
        "home:Cup a :Item | home:Cup a :Itm"
            + " | Cup rdf:type Itm is no known class; write :Item, if that is meant",
        "\"4.1 1.5 2.8\" | \"4.1 1.5\" | lamp-b1 maestro:pose \"4.1 1.5\" is not understood",
        "maestro:outline \"3 0, 6 0, 6 3, 3 3\" ; maestro:ref"
            + " | maestro:outline \"2 0, 6 0, 6 3, 3 3\" ; maestro:ref"
            + " | zone-b maestro:outline overlaps the zone zone-a",
        "maestro:outline \"3 0, 6 0, 6 3, 3 3\" ; maestro:ref | maestro:ref"
            + " | zone-b maestro:outline is missing; write its corners",
        "home:lamp-b1 a :Lamp | home:Lamp_B1 a :Lamp | Lamp_B1 is no device id; write small",
        "home:Cup a :Item | home:Item a :Item"
            + " | Item has the name of a word of the vocabulary; give it another name",
        "maestro:openingFrom \"3 1.9\" ; | ` ` | door-ab maestro:openingFrom is missing",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ; maestro:offers :measureLight ;"
            + " | lux-b maestro:offers measureLight is no known feature",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ; maestro:offers [ a"
            + " :measureIllumination ; maestro:precondition \"(senses ?self\" ] ; | lux-b"
            + " maestro:precondition \"(senses ?self\" is not MAESTRO-SL: at column 14",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ; maestro:offers [ a"
            + " :measureIllumination ; maestro:precondition \"(sense ?self)\" ] ; | is not"
            + " MAESTRO-SL: at column 1 stands",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ;"
            + " maestro:offers [ a :measureIllumination ; maestro:effect \"(sens ?self ?zone)\" ] ;"
            + " | lux-b maestro:effect uses the unknown predicate sens;",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ;"
            + " maestro:offers [ a :measureIllumination ; maestro:effect \"(open ?zone ?self)\" ] ;"
            + " | lux-b maestro:effect gives open 2 arguments; write (open ?d - Door)",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ; maestro:offers [ a"
            + " :measureIllumination ; maestro:effect \"(senses ?self ?zone)\" ] ; | lux-b"
            + " maestro:effect sets senses, which follows from other facts;",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ;"
            + " maestro:offers [ a :measureIllumination ; maestro:cost \"(power ?sef)\" ] ;"
            + " | lux-b maestro:cost uses ?sef, which nothing binds; write ?self",
        "home:lux-b a :LightSensor ; | home:lux-b a :LightSensor ;"
            + " maestro:offers [ a :measureIllumination ; maestro:cost \"(in ?self ?zone)\" ] ;"
            + " | lux-b maestro:cost uses in as a number, which is true or false;",
      })
  void namesLineSubjectPropertyProblemAndCure(String right, String wrong, String expected) {
    String replacement = wrong.isBlank() ? "" : wrong;
    assertThat(BOB).contains(right);
    String text = BOB.replace(right, replacement);
    HomeFaultException refusal =
        catchThrowableOfType(
            HomeFaultException.class, () -> new HomeLoader().load(text, "bob.ttl"));
    assertThat(refusal).isNotNull();
    assertThat(refusal.faults()).extracting(Fault::toString).anyMatch(f -> f.contains(expected));
    Fault fault =
        refusal.faults().stream()
            .filter(f -> f.toString().contains(expected))
            .findFirst()
            .orElseThrow();
    int changed = (int) BOB.substring(0, BOB.indexOf(right)).lines().count();
    assertThat(fault.line()).isBetween(changed - 1, changed + 2);
    assertThat(fault.toString()).startsWith("bob.ttl:" + fault.line() + ": ").doesNotContain("\n");
  }

  @Test
  void aWatchedZoneNeedsADeviceThatSeesIt() {
    String narrow = BOB.replaceFirst("viewAngle 75", "viewAngle 50");
    HomeFaultException refusal =
        catchThrowableOfType(
            HomeFaultException.class, () -> new HomeLoader().load(narrow, "bob.ttl"));
    assertThat(refusal)
        .hasMessageContaining("zone-a maestro:watched asks for a device that sees 95 %")
        .hasMessageContaining("the best sees 60 %");
    int line = (int) BOB.substring(0, BOB.indexOf("maestro:watched")).lines().count();
    assertThat(refusal.faults()).extracting(Fault::line).containsExactly(line);
  }

  @Test
  void tellsEveryFaultAtOnce() {
    HomeFaultException refusal =
        catchThrowableOfType(
            HomeFaultException.class,
            () ->
                new HomeLoader()
                    .load(
                        BOB.replace(":power 7", ":power \"seven\"")
                            .replace(":mass 0.25", ":mass \"light\""),
                        "bob.ttl"));
    assertThat(refusal.faults()).hasSize(2).isSortedAccordingTo((a, b) -> a.line() - b.line());
    assertThat(refusal).hasMessageContaining("(and 1 more faults)");
  }

  @Test
  void namesTheLineOfATurtleFault() {
    int line = (int) BOB.substring(0, BOB.indexOf("home:Cup a")).lines().count() + 1;
    HomeFaultException refusal =
        catchThrowableOfType(
            HomeFaultException.class,
            () -> new HomeLoader().load(BOB.replace("home:Cup a", "home:Cup a ;;"), "bob.ttl"));
    assertThat(refusal.faults()).hasSize(1);
    assertThat(refusal.faults().get(0).line()).isEqualTo(line);
  }

  /** So that a file of which half is there is not taken for a whole one. */
  @Test
  void aLastStatementWithoutItsDotIsAFault() {
    String cut = BOB.strip().replaceFirst("\\.$", "");
    HomeFaultException refusal =
        catchThrowableOfType(HomeFaultException.class, () -> new HomeLoader().load(cut, "bob.ttl"));
    assertThat(refusal).hasMessageContaining("not terminated by DOT");
    assertThat(refusal.faults().get(0).line()).isEqualTo((int) cut.strip().lines().count());

    String lamp = "<#lamp-9> a <https://w3id.org/maestro/domain#Lamp>";
    DescriptionReader reader = DescriptionReader.of(ShippedHomes.bob());
    assertThat(
            catchThrowableOfType(
                HomeFaultException.class,
                () -> new DeviceFile(reader::read).read(lamp, "lamp-9.ttl")))
        .hasMessageContaining("lamp-9.ttl:1: the text has a fault");
  }

  @Test
  void aMissingFileAndAFileWithoutHomeAreFaultsToo() {
    assertThat(
            catchThrowableOfType(
                HomeFaultException.class, () -> new HomeLoader().load(Path.of("nowhere.ttl"))))
        .hasMessageContaining("nowhere.ttl: the file cannot be read");
    assertThat(
            catchThrowableOfType(
                HomeFaultException.class, () -> new HomeLoader().load("", "empty.ttl")))
        .hasMessageContaining("empty.ttl:1: the file describes no home");
  }

  @Test
  void faultsOfAReplacedVocabularyAreFound() {
    String vocabulary =
        HomeLoader.shippedVocabulary().replace("(viewShare ?d ?z)", "(viewshare ?d ?z)");
    HomeFaultException refusal =
        catchThrowableOfType(
            HomeFaultException.class,
            () -> HomeLoader.withVocabulary(List.of(vocabulary)).load(BOB, "bob.ttl"));
    assertThat(refusal)
        .hasMessageContaining("covers maestro:derivedWhen uses the unknown fluent viewshare")
        .hasMessageContaining("write viewShare, if that is meant");
  }

  @Test
  void aHomeLoadsWithARenamedVocabulary() {
    String renamed = HomeLoader.shippedVocabulary().replace("illuminance", "brightness");
    Home home =
        HomeLoader.withVocabulary(List.of(renamed))
            .load(BOB.replace("illuminance", "brightness"), "bob.ttl");
    assertThat(home.vocabulary().predicates()).containsKey("brightness");
  }
}
