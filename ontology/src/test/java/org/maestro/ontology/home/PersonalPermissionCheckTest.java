package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** A slip in what persons may have done is a fault with its line and its cure. */
class PersonalPermissionCheckTest {
  private static String evening;

  @BeforeAll
  static void read() throws IOException {
    evening =
        Files.readString(Path.of("../scenarios/assembly/src/main/resources/homes/evening.ttl"));
  }

  private static String fault(String permission) {
    return catchThrowableOfType(
            HomeFaultException.class,
            () ->
                new HomeLoader()
                    .load(
                        evening + "home:p a maestro:Permission ; " + permission + " .",
                        "evening.ttl"))
        .getMessage();
  }

  @Test
  void anUnknownPersonIsTold() {
    assertThat(fault("maestro:person home:Toom ; maestro:forbids :switchOn"))
        .contains("evening.ttl:" + (evening.lines().count() + 1))
        .contains("p maestro:person Toom is neither a person of this home nor a class of persons")
        .contains("home:Tom");
    assertThat(fault("maestro:person home:oven ; maestro:forbids :switchOn"))
        .contains("p maestro:person oven is neither a person of this home nor a class of persons");
    assertThat(fault("maestro:person :Lamp ; maestro:forbids :switchOn"))
        .contains("p maestro:person Lamp is neither a person");
  }

  @Test
  void anUnknownFeatureAndOneThatTheDeviceDoesNotOfferAreTold() {
    assertThat(fault("maestro:person :Child ; maestro:forbids :switchOnn"))
        .contains("p maestro:forbids switchOnn is no feature that is known here")
        .contains(":switchOn");
    assertThat(fault("maestro:person :Child ; maestro:asks home:hob ; maestro:forbids :setVolume"))
        .contains("names setVolume, which hob does not offer");
  }

  @Test
  void aConditionSpeaksOfTheParametersAndOfNumbers() {
    assertThat(
            fault(
                "maestro:person :Child ; maestro:permits :setVolume ; maestro:when \"(<="
                    + " ?volum 60)\""))
        .contains("uses ?volum, which nothing binds")
        .contains("?volume");
    assertThat(
            fault(
                "maestro:person :Child ; maestro:permits :setVolume ; maestro:when \"(<= ?volume"
                    + " 60\""))
        .contains("maestro:when")
        .contains("is not MAESTRO-SL");
    assertThat(
            fault("maestro:person :Child ; maestro:forbids :pour ; maestro:when \"(> ?drink 3)\""))
        .contains("compares ?drink, a Beverage, with 3")
        .contains("name a parameter that is a number");
    assertThat(fault("maestro:person :Child ; maestro:permits :setVolume ; maestro:when 60"))
        .contains("is not a text");
    assertThat(
            fault(
                "maestro:person :Child ; maestro:forbids :pour ; maestro:when \"(= ?drink"
                    + " Whisky)\""))
        .contains("names Whisky, which is not described");
  }

  @Test
  void whatIsSaidOfPersonsIsNotSaidOfCallers() {
    assertThat(fault("maestro:caller \"tablet\" ; maestro:forbids :switchOn"))
        .contains("p maestro:forbids switchOn is said of persons only")
        .contains("add maestro:person");
    assertThat(fault("maestro:caller \"tablet\" ; maestro:person :Child"))
        .contains("state two permissions");
    assertThat(fault("maestro:forbids :switchOn")).contains("maestro:caller is missing");
  }
}
