/* A bell on the RATS bus, with a C compiler and sockets and nothing else: the least that a device must do.
 *
 *   cc -std=c11 -Os -o bell *.c
 *   ./bell HOST PORT SITE
 *
 * No memory is allocated while it runs: all of it is static, and what is bigger is refused. For sites that are not
 * secured. */
#define _POSIX_C_SOURCE 200809L
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "json.h"
#include "mqtt.h"

#define ME "bell-1"

enum {
  MOST_ID = 128,
  MOST_NAME = 63,
  MOST_T_MS = 604800000,
  MOST_SETS = 16,       /* whose prices are asked for at once */
  MOST_REMEMBERED = 64, /* calls whose answers are known */
  REMEMBERED_MS = 600000,
  STROKES = 3,
  STROKE_MS = 300
};

static const char DESCRIPTION[] =
    "{\"@context\":[\"https://w3id.org/maestro/context.jsonld\",{\"b\":\"https://example.org/bells#\"}],"
    "\"id\":\"b:" ME "\",\"label\":\"the bell\",\"type\":\"b:Bell\","
    "\"offers\":{\"id\":\"b:ring\",\"type\":\"maestro:Task\",\"sentence\":\"{self} rings\","
    "\"effect\":\"(rung ?self)\",\"occupies\":[\"clapper\"],\"cost\":\"1\",\"seconds\":\"0.9\"},"
    "\"brings\":[{\"id\":\"b:Bell\",\"type\":\"owl:Class\",\"subClassOf\":\"maestro:Device\"},"
    "{\"id\":\"b:rung\",\"type\":\"maestro:Predicate\",\"label\":\"rung\",\"arguments\":[\"?bell - Bell\"]}]}";

/* What becomes of a call. One byte is enough to remember it, as all of it is known beforehand. */
typedef enum {
  UNDER_WAY, DONE, PRICED, FOUND, NOT_FOUND, ENDED, LATE, OTHER_VERSION, OTHER_BOOT, OTHER_BODY, BROKEN, WRONG_FROM,
  WRONG_F, WRONG_P, WRONG_T, UNKNOWN, NO_ID, NO_SETS, BUSY
} Answer;

static const struct {
  const char *outcome, *values, *code, *message;
  bool retriable;
} ANSWERS[] = {
    [DONE] = {"SUCCEEDED", "{}", NULL, NULL, false},
    [PRICED] = {"SUCCEEDED", NULL, NULL, NULL, false},
    [FOUND] = {"SUCCEEDED", "{\"found\":true}", NULL, NULL, false},
    [NOT_FOUND] = {"SUCCEEDED", "{\"found\":false}", NULL, NULL, false},
    [ENDED] = {"CANCELED", "{}", "CANCELED", "The call was ended before it was done", true},
    [LATE] = {"TIMED_OUT", "{}", "TIMEOUT", "The time of the call was over before it was done", true},
    [OTHER_VERSION] = {"REJECTED", "{}", "UNSUPPORTED_VERSION", "The bell understands version 1", false},
    [OTHER_BOOT] = {"REJECTED", "{}", "RESTARTED", "The call was meant for another life of the bell", true},
    [OTHER_BODY] = {"REJECTED", "{}", "DUPLICATE_ID", "Another call of that id came before", false},
    [BROKEN] = {"REJECTED", "{}", "MALFORMED", "The call is no JSON object, deeper than 16 levels, or too long", false},
    [WRONG_FROM] = {"REJECTED", "{}", "MALFORMED", "from must be the name of who calls", false},
    [WRONG_F] = {"REJECTED", "{}", "MALFORMED", "f must be a text", false},
    [WRONG_P] = {"REJECTED", "{}", "MALFORMED", "p must be an object", false},
    [WRONG_T] = {"REJECTED", "{}", "MALFORMED", "t must be an integer from 1 to 604800000", false},
    [UNKNOWN] = {"REJECTED", "{}", "UNKNOWN_FEATURE", "The bell rings, and has no other feature", false},
    [NO_ID] = {"REJECTED", "{}", "INVALID_PARAMETERS", "$cancel needs the parameter id, a call's id", false},
    [NO_SETS] = {"REJECTED", "{}", "INVALID_PARAMETERS", "$cost needs feature, and sets, a list of 16 at most", false},
    [BUSY] = {"REJECTED", "{}", "QUEUE_FULL", "The bell does one thing after the other; try later", true}};

static char site[MOST_NAME + 1], boot[20];

static int64_t milliseconds(Text digits) { /* 0 where it is nothing that t may be */
  int64_t number = 0;
  for (; digits.at < digits.end && number <= MOST_T_MS; digits.at++) {
    if (!is_digit(*digits.at)) return 0;
    number = number * 10 + (*digits.at - '0');
  }
  return number <= MOST_T_MS ? number : 0;
}

static bool is_name(Text text) { /* what may be a level of a topic */
  bool right = text.at < text.end && text_length(text) <= MOST_NAME && !one_of("._-", *text.at);
  for (; text.at < text.end; text.at++)
    right = right && (is_letter(*text.at) || is_digit(*text.at) || one_of("._-", *text.at));
  return right;
}

static bool is_id(Text text) {
  bool right = text.at < text.end && text_length(text) <= MOST_ID;
  for (; text.at < text.end; text.at++) right = right && (unsigned char)*text.at > ' ';
  return right;
}

/* --- What it tells of itself */

static struct { /* the call that is under way, or was the last one */
  struct Memory *memory;
  char id[MOST_ID + 1], from[MOST_NAME + 1];
  int strokes;
  int64_t next_ms, end_ms;
} ringing;
static const char *last_outcome; /* of that call; none while it is under way */
static bool has_rung;

#define STATUS "{\"v\":\"1.0\",\"id\":\"" ME "\",\"status\":\"%s\",\"boot\":\"%s\"}"

static const char *state(void) { return ringing.memory != NULL ? "ringing" : "standby"; }

static void tell_state(void) {
  mqtt_begin("rats/1/%s/member/" ME "/state", site);
  mqtt_say("{\"v\":\"1.0\",\"id\":\"" ME "\",\"boot\":\"%s\",\"z\":\"%s\",\"values\":[%s]", boot, state(),
           has_rung ? "\"(rung " ME ")\"" : "");
  mqtt_say(",\"queue\":[],\"disabled\":[],\"running\":[");
  if (ringing.memory != NULL) mqtt_say("\"%s\"", ringing.id);
  mqtt_say("],\"recent\":[");
  if (last_outcome != NULL) mqtt_say("{\"id\":\"%s\",\"outcome\":\"%s\"}", ringing.id, last_outcome);
  mqtt_say("]}");
  mqtt_send(true);
}

static void announce(void) {
  mqtt_begin("rats/1/%s/member/" ME "/description", site);
  mqtt_say("%s", DESCRIPTION);
  mqtt_send(true);
  tell_state();
  mqtt_begin("rats/1/%s/member/" ME "/status", site);
  mqtt_say(STATUS, "ready", boot);
  mqtt_send(true);
}

static void tell_result(Text from, Text id, Answer answer, int sets) {
  mqtt_begin("rats/1/%s/result/%.*s/" ME, site, text_length(from), from.at);
  mqtt_say("{\"v\":\"1.0\",\"id\":\"%.*s\",\"from\":\"" ME "\",\"outcome\":\"%s\",\"z\":\"%s\",\"values\":",
           text_length(id), id.at, ANSWERS[answer].outcome, state());
  if (answer == PRICED) {
    mqtt_say("{\"costs\":[");
    for (int i = 0; i < sets; i++) mqtt_say("%s{\"cost\":1,\"seconds\":0.9}", i > 0 ? "," : "");
    mqtt_say("]}");
  } else {
    mqtt_say("%s", ANSWERS[answer].values);
  }
  if (ANSWERS[answer].code != NULL)
    mqtt_say(",\"error\":{\"code\":\"%s\",\"level\":\"WARNING\",\"message\":\"%s\",\"refs\":[],\"retriable\":%s}",
             ANSWERS[answer].code, ANSWERS[answer].message, ANSWERS[answer].retriable ? "true" : "false");
  mqtt_say("}");
  mqtt_send(false);
}

/* --- Calls: each is done once, and the same call again gets the same answer */

static struct Memory {
  uint64_t call, body;
  int64_t until_ms;
  unsigned char answer;
  bool has_moved; /* it must not be forgotten before its time, or it would be done twice */
} remembered[MOST_REMEMBERED];

typedef struct {
  Text id, from, feature, parameters;
  int64_t t_ms;
} Call;

static uint64_t hash(uint64_t before, Text text) { /* FNV-1a */
  for (; text.at < text.end; text.at++) before = (before ^ (unsigned char)*text.at) * 1099511628211u;
  return (before ^ 0xff) * 1099511628211u;
}

static struct Memory *room(void) { /* none: all of them are needed */
  struct Memory *best = NULL;
  for (struct Memory *one = remembered; one < remembered + MOST_REMEMBERED; one++) {
    bool may_go = one != ringing.memory && (!one->has_moved || one->until_ms <= now_ms());
    if (may_go && (best == NULL || one->until_ms < best->until_ms)) best = one;
  }
  return best;
}

static int sets_of(Text parameters) { /* how many; -1 when they are no list */
  Text list, one;
  int count = 0;
  if (!json_field(parameters, "sets", &list) || !json_next(&list, '[')) return -1;
  while (json_value(&list, 2, &one)) {
    count++;
    json_next(&list, ',');
  }
  return count;
}

static void end_ringing(Answer answer) {
  Text id = {ringing.id, ringing.id + strlen(ringing.id)};
  Text from = {ringing.from, ringing.from + strlen(ringing.from)};
  ringing.memory->answer = (unsigned char)answer;
  ringing.memory = NULL;
  last_outcome = ANSWERS[answer].outcome;
  has_rung = has_rung || answer == DONE;
  tell_state(); /* before the result, so that whoever hears it knows what is so */
  tell_result(from, id, answer, 0);
}

static Answer begin_ringing(const Call *call, struct Memory *memory) {
  if (ringing.memory != NULL || memory == NULL) return BUSY;
  ringing.memory = memory;
  snprintf(ringing.id, sizeof ringing.id, "%.*s", text_length(call->id), call->id.at);
  snprintf(ringing.from, sizeof ringing.from, "%.*s", text_length(call->from), call->from.at);
  ringing.strokes = 0;
  ringing.next_ms = now_ms();
  ringing.end_ms = now_ms() + call->t_ms;
  last_outcome = NULL;
  memory->has_moved = true;
  tell_state();
  return UNDER_WAY;
}

static Answer perform(const Call *call, struct Memory *memory) {
  Text what;
  if (text_is(call->feature, "ring")) return begin_ringing(call, memory);
  if (text_is(call->feature, "$ping")) return DONE;
  if (text_is(call->feature, "$describe")) return announce(), DONE;
  if (text_is(call->feature, "$safe")) {
    if (ringing.memory != NULL) end_ringing(ENDED);
    return DONE;
  }
  if (text_is(call->feature, "$cancel")) {
    if (!json_text(call->parameters, "id", &what)) return NO_ID;
    if (ringing.memory == NULL || !text_is(what, ringing.id)) return NOT_FOUND;
    end_ringing(ENDED);
    return FOUND;
  }
  if (text_is(call->feature, "$cost")) {
    int sets = sets_of(call->parameters);
    if (!json_text(call->parameters, "feature", &what) || sets < 0 || sets > MOST_SETS) return NO_SETS;
    return text_is(what, "ring") ? PRICED : UNKNOWN;
  }
  return UNKNOWN;
}

static void take(const Call *call) {
  uint64_t key = hash(hash(14695981039346656037u, call->from), call->id);
  uint64_t body = hash(hash(14695981039346656037u, call->feature), call->parameters);
  struct Memory *known = NULL;
  for (int i = 0; i < MOST_REMEMBERED; i++)
    if (remembered[i].until_ms > now_ms() && remembered[i].call == key) known = &remembered[i];
  Answer answer = known == NULL ? UNDER_WAY : known->body == body ? (Answer)known->answer : OTHER_BODY;
  if (known == NULL) {
    struct Memory *memory = room();
    int64_t answered_ms = now_ms() + call->t_ms; /* at the latest, and from then on it is remembered */
    int64_t until_ms = answered_ms + (call->t_ms > REMEMBERED_MS ? call->t_ms : REMEMBERED_MS);
    if (memory != NULL) *memory = (struct Memory){key, body, until_ms, UNDER_WAY, false};
    answer = perform(call, memory);
    if (memory != NULL) memory->answer = (unsigned char)answer;
  }
  if (answer != UNDER_WAY) tell_result(call->from, call->id, answer, sets_of(call->parameters));
}

static bool is_mine(Text feature) {
  static const char *const FEATURES[] = {"ring", "$ping", "$describe", "$safe", "$cancel", "$cost"};
  bool found = false;
  for (size_t i = 0; i < sizeof FEATURES / sizeof *FEATURES; i++) found = found || text_is(feature, FEATURES[i]);
  return found;
}

static bool is_version(Text text) {
  bool right = text_length(text) > 2 && text.at[0] == '1' && text.at[1] == '.';
  for (const char *c = text.at + 2; right && c < text.end; c++) right = is_digit(*c);
  return right;
}

/* Why a call cannot be taken; UNDER_WAY when it can. */
static Answer fault_of(Text message, bool is_whole, Call *call) {
  Text part;
  if (!is_whole) return BROKEN;
  if (!json_text(message, "v", &part) || !is_version(part)) return OTHER_VERSION;
  if (!json_text(message, "from", &part) || !is_name(part)) return WRONG_FROM;
  if (!json_text(message, "f", &call->feature)) return WRONG_F;
  if (json_field(message, "p", &part)) call->parameters = part;
  if (json_field(message, "p", &part) && *part.at != '{') return WRONG_P;
  call->t_ms = json_field(message, "t", &part) ? milliseconds(part) : 0;
  if (call->t_ms == 0) return WRONG_T;
  return json_text(message, "boot", &part) && !text_is(part, boot) ? OTHER_BOOT : UNDER_WAY;
}

/* `caller` is who the topic says that calls; on the bare topic, where it is empty, anybody may. */
static void heard_call(Text caller, Text message) {
  Text all = message, whole, to, feature, from = caller;
  Call call = {.parameters = {message.at, message.at}};
  bool is_whole = json_value(&all, 0, &whole) && !json_next(&all, 0) && all.at == all.end;
  bool is_to_all = is_whole && (!json_field(message, "r", &to) || text_is(to, "\"\""));
  bool is_for_me = is_to_all ? json_text(message, "f", &feature) && is_mine(feature)
                             : json_text(message, "r", &to) && text_is(to, ME);
  bool names_sender = json_text(message, "from", &from) && is_name(from);
  if (!is_for_me || !json_text(message, "id", &call.id) || !is_id(call.id)) return;
  if (text_length(caller) == 0 ? !names_sender : names_sender && !text_same(from, caller)) return;
  call.from = names_sender ? from : caller;
  Answer fault = fault_of(message, is_whole, &call);
  if (fault == UNDER_WAY) take(&call);
  else tell_result(call.from, call.id, fault, 0);
}

static void work(void) { /* on what is under way, as far as it is due */
  if (ringing.memory == NULL) return;
  if (now_ms() >= ringing.end_ms) {
    end_ringing(LATE);
  } else if (now_ms() >= ringing.next_ms && ringing.strokes == STROKES) {
    end_ringing(DONE);
  } else if (now_ms() >= ringing.next_ms) {
    puts("ding");
    ringing.strokes++;
    ringing.next_ms += STROKE_MS;
  }
}

/* --- The bus */

/* A will that came late, or another's word, must not be the last. */
static void said_of_me(Text topic, Text message) {
  static const char END[] = "/description";
  int length = text_length(topic), end = (int)sizeof END - 1;
  Text status;
  bool is_right = length >= end && memcmp(topic.end - end, END, (size_t)end) == 0
                      ? text_is(message, DESCRIPTION)
                      : json_text(message, "status", &status) && text_is(status, "ready");
  if (!is_right) announce();
}

static void heard(const Message *message) {
  char calls[MOST_TOPIC];
  int length = snprintf(calls, sizeof calls, "rats/1/%s/call", site);
  if (text_length(message->topic) < length || memcmp(message->topic.at, calls, (size_t)length) != 0) {
    said_of_me(message->topic, message->payload);
  } else if (!message->is_retained) {
    bool is_bare = text_length(message->topic) == length;
    Text caller = {message->topic.at + length + (is_bare ? 0 : 1), message->topic.end};
    if (is_bare || is_name(caller)) heard_call(caller, message->payload);
  }
}

static bool join(const char *host, const char *port) {
  char topic[MOST_TOPIC], will[MOST_TOPIC];
  snprintf(topic, sizeof topic, "rats/1/%s/member/" ME "/status", site);
  snprintf(will, sizeof will, STATUS, "lost", boot);
  if (!mqtt_connect(host, port, ME, topic, will)) return false;
  snprintf(topic, sizeof topic, "rats/1/%s/member/" ME "/+", site);
  mqtt_hear(topic, HEAR_OTHERS);
  snprintf(topic, sizeof topic, "rats/1/%s/call/#", site);
  mqtt_hear(topic, HEAR_ALL);
  announce();
  return true;
}

static void live(void) {
  for (Event event = NOTHING; event != GONE; work()) {
    Message message;
    int64_t due_ms = ringing.next_ms < ringing.end_ms ? ringing.next_ms : ringing.end_ms;
    event = mqtt_wait(ringing.memory == NULL ? INT64_MAX : due_ms, &message);
    if (event == MESSAGE) heard(&message);
    if (event == TAKEN_OVER) { /* else both would throw each other off for ever */
      fprintf(stderr, "There is another " ME "; this one leaves. Give it an id of its own.\n");
      exit(1);
    }
  }
}

int main(int count, char **words) {
  struct timespec born;
  if (count != 4 || !is_name((Text){words[3], words[3] + strlen(words[3])})) {
    fprintf(stderr, "Say where: bell HOST PORT SITE\n");
    return 2;
  }
  clock_gettime(CLOCK_REALTIME, &born); /* another start is another boot */
  snprintf(boot, sizeof boot, "b%llx", (unsigned long long)born.tv_sec * 1000000000u + (unsigned long)born.tv_nsec);
  snprintf(site, sizeof site, "%s", words[3]);
  setvbuf(stdout, NULL, _IOLBF, 0);
  for (int seconds = 1;; seconds = seconds < 16 ? 2 * seconds : 30) {
    if (join(words[1], words[2])) {
      live();
      seconds = 1;
    }
    for (int64_t again_ms = now_ms() + seconds * 1000; now_ms() < again_ms; work()) poll(NULL, 0, 50);
  }
}
