package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.experiment.running.Ending;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.SceneLoader;

/**
 * A robot with a camera on board searches three rooms in a row, of which the sun over-lights the
 * first; nobody can close the window.
 */
@Tag("full")
class SunlitSearchTest {
  private static final Home HOME =
      new HomeLoader()
          .load(
              """
              @prefix : <https://w3id.org/maestro/domain#> .
              @prefix home: <https://w3id.org/maestro/home/sunlit#> .
              @prefix maestro: <https://w3id.org/maestro#> .
              @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
              <https://w3id.org/maestro/home/sunlit> a maestro:Home ; rdfs:label "sunlit"@en .
              home:room-1 a maestro:Room ; rdfs:label "1"@en ; maestro:outline "0 0, 3 0, 3 4, 0 4" ; maestro:height 2.6 .
              home:room-2 a maestro:Room ; rdfs:label "2"@en ; maestro:outline "3 0, 6 0, 6 4, 3 4" ; maestro:height 2.6 .
              home:room-3 a maestro:Room ; rdfs:label "3"@en ; maestro:outline "6 0, 9 0, 9 4, 6 4" ; maestro:height 2.6 .
              home:first a maestro:Zone ; rdfs:label "1"@en ; maestro:outline "0 0, 3 0, 3 4, 0 4" ;
                maestro:referencePoint "0.1 3.9 0" .
              home:second a maestro:Zone ; rdfs:label "2"@en ; maestro:outline "3 0, 6 0, 6 4, 3 4" ;
                maestro:referencePoint "4.5 3.9 0" .
              home:third a maestro:Zone ; rdfs:label "3"@en ; maestro:outline "6 0, 9 0, 9 4, 6 4" ;
                maestro:referencePoint "7.5 3.9 0" .
              home:door-1 a maestro:Door ; rdfs:label "door 1"@en ; maestro:openingFrom "3 1.2" ; maestro:openingTo "3 2.4" ;
                :side home:first , home:second ; :open true .
              home:door-2 a maestro:Door ; rdfs:label "door 2"@en ; maestro:openingFrom "6 1.2" ; maestro:openingTo "6 2.4" ;
                :side home:second , home:third ; :open true .
              home:window a maestro:Window ; rdfs:label "window"@en ; maestro:glassFrom "1 0 1" ; maestro:glassTo "2.6 0 2" .
              home:Cup a :Item ; rdfs:label "cup"@en ; :colour "red" ; :size "0.08 0.08 0.1" ; :mass 0.2 .
              home:Red a :Item ; rdfs:label "another"@en ; :colour "red" ; :size "0.08 0.08 0.1" ; :mass 0.2 .
              home:lux-1 a :LightSensor ; rdfs:label "l1"@en ; maestro:pose "0.1 3.9 0" .
              home:lux-2 a :LightSensor ; rdfs:label "l2"@en ; maestro:pose "4.5 3.9 0" .
              home:lux-3 a :LightSensor ; rdfs:label "l3"@en ; maestro:pose "7.5 3.9 0" .
              home:rose a :SearchingRobot ; rdfs:label "Rose"@en ; :colour "orange" ; :size "0.58 0.38 0.6" ;
                :speed 0.8 ; :payload 0.5 ; maestro:viewAngle 75 ; :minimumIlluminance 72 ; :maximumIlluminance 2000 .
              """,
              "sunlit.ttl");

  private static TrialSite site(String cupAt, String robotAt) {
    String turtle =
        """
        @prefix scene: <%s> .
        <https://w3id.org/maestro/home/sunlit> scene:latitude 50 ; scene:dayOfYear 81 ; scene:solarTime "12:00" .
        <#rose> scene:position "%s" .
        <#Cup> scene:position "%s" .
        <#Red> scene:position "8.4 3.4 0" .
        <#first> scene:ambientLux 150 .
        <#second> scene:ambientLux 150 .
        <#third> scene:ambientLux 150 .
        """
            .formatted("https://w3id.org/maestro/scene#", robotAt, cupAt);
    return TrialSite.open(
        new Trial(
            "sunlit",
            HOME,
            SceneLoader.load(
                "sunlit", new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)), HOME),
            1,
            PhysicalParameters.standard()));
  }

  /** In the sun, in the room beside it, and in the one from which no door leads there. */
  @ParameterizedTest
  @ValueSource(strings = {"1.8 1.8 0", "5.4 0.6 0", "6.6 0.6 0"})
  void whereverTheCupIsTheSearchEndsWithoutAFalseClaim(String cupAt) {
    try (TrialSite site = site(cupAt, "1.5 3.2 0")) {
      Ending ending = site.pursue("(in Cup rose)", Duration.ofMinutes(10));

      assertThat(ending.report()).as("it ends").isPresent();
      assertThat(ending.replans()).as(told(ending)).isLessThan(20);
      assertThat(ending.claimed())
          .as(told(ending))
          .isEqualTo(site.world().held("rose").filter("Cup"::equals).isPresent());
      assertThat(ending.claimed() || ending.explanation().contains("over-lit"))
          .as(told(ending))
          .isTrue();
    }
  }

  @Test
  void whatLiesInNoSunAndIsSeenFromNoneIsFetched() {
    try (TrialSite site = site("8.4 0.6 0", "7.5 3.2 0")) {
      Ending ending = site.pursue("(in Cup rose)", Duration.ofMinutes(10));

      assertThat(ending.claimed()).as(told(ending)).isTrue();
      assertThat(site.world().held("rose")).contains("Cup");
    }
  }

  private static String told(Ending ending) {
    return String.join("\n", ending.story().stream().map(entry -> entry.text()).toList());
  }
}
