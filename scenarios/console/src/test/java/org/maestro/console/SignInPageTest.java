package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.rats.security.Role;
import org.openqa.selenium.Keys;

/** The page of a secured site, as persons of two roles see it. */
@Isolated("its time is wall time, which others beside it would take")
class SignInPageTest {
  @TempDir static Path files;
  private static ServedHome home;
  private static Browser browser;

  @BeforeAll
  static void open() {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    home =
        ServedHome.startSecured(files, Map.of("alice", Role.OPERATOR, "screen", Role.VIEWER), "");
    browser = Browser.open();
    browser.size(1440, 900);
  }

  @AfterAll
  static void close() {
    if (browser != null) {
      browser.close();
    }
    if (home != null) {
      home.close();
    }
  }

  private static String password(String person) throws IOException {
    return Files.readString(files.resolve("users/" + person + "/console-password")).strip();
  }

  private static void signIn(String person, String password) {
    browser.waitFor("#sign-in:not([hidden])");
    browser.run("document.getElementById('sign-in-name').value = ''");
    browser.waitFor("#sign-in-name").sendKeys(person);
    browser.waitFor("#sign-in-password").clear();
    browser.waitFor("#sign-in-password").sendKeys(password, Keys.ENTER);
  }

  @Test
  void whoSignsInSeesTheHomeAndMayWhatHerRoleSays() throws Exception {
    browser.open(home.uri() + "/#view=goals");
    browser.waitFor("#sign-in:not([hidden])");
    assertThat(browser.text("#plan")).as("nothing is told yet").doesNotContain("room A");
    assertThat(Accessibility.faults(browser)).isEmpty();

    signIn("screen", "guessed wrongly");
    browser.waitForText("#sign-in-problem", "The name or the password is wrong");

    signIn("screen", password("screen"));
    browser.waitFor("#link.live");
    browser.waitForText("#plan", "room A");
    browser.waitForText("#person-name", "screen, viewer");
    browser.waitFor("#goal-form button[type=submit]:disabled");
    browser.waitFor("#stop:disabled");
    assertThat(browser.waitFor("#stop").getDomProperty("title"))
        .isEqualTo("It takes an operator; screen is a viewer here.");
    browser.waitFor("#goal-preview:not(:disabled)");
    assertThat(Accessibility.faults(browser)).isEmpty();

    browser.click("#sign-out");
    signIn("alice", password("alice"));
    browser.waitForText("#person-name", "alice, operator");
    browser.waitFor("#goal-form button[type=submit]:not(:disabled)");
    browser.waitFor("#goal-input").sendKeys("(canSee ?who Bob)", Keys.ENTER);
    browser.waitForText("#detail .story", "desk@alice asks for");
    browser.waitForText("#detail .story", "Reached");
  }
}
